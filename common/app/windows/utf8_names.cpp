// Names of files are UTF-8, as on other systems. Up to version 12, the library of g++ turns each
// byte of a std::filesystem::path into a wide character. It calls this function for that, so the
// program replaces the function.
#include <codecvt>

namespace std {

codecvt_base::result codecvt<wchar_t, char, mbstate_t>::do_in(mbstate_t& state, const char* from,
                                                              const char* from_end,
                                                              const char*& from_next, wchar_t* into,
                                                              wchar_t* into_end,
                                                              wchar_t*& into_next) const {
    static const codecvt_utf8_utf16<wchar_t> utf8;
    return utf8.in(state, from, from_end, from_next, into, into_end, into_next);
}

}  // namespace std
