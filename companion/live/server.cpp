#include <app/errors.hpp>
#include <companion/live/server.hpp>
#include <companion/system/secret.hpp>
#ifdef COURSE_HAS_HTTPLIB
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#endif

namespace companion {
namespace {

int value_of_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

// Without %20 and the like; nothing if a % begins none, or if there is what no address holds.
std::optional<std::string> decoded(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '%') {
            if (i + 2 >= text.size()) return {};
            const int high = value_of_digit(text[i + 1]), low = value_of_digit(text[i + 2]);
            if (high < 0 || low < 0) return {};
            c = static_cast<char>(16 * high + low);
            i += 2;
        }
        if (static_cast<unsigned char>(c) < ' ' || c == 0x7f || c == '\\') return {};
        plain += c;
    }
    return plain;
}

// The parts of a text between these characters.
std::vector<std::string> split(const std::string& text, char between) {
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == between)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

}  // namespace

Asked read_target(const std::string& target, const std::string& secret) {
    const std::string whole = target.substr(0, target.find('#'));
    const auto mark = whole.find('?');
    const auto path = decoded(whole.substr(0, mark));
    if (!path || path->empty() || path->front() != '/') return {.refused = 400};
    std::vector<std::string> parts = split(path->substr(1), '/');
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i] == "." || parts[i] == ".." || (parts[i].empty() && i + 1 < parts.size()))
            return {.refused = 400};
    if (parts[0] != secret) return {.refused = 403};
    if (parts.size() == 1) return {.refused = 404};  // "/SECRET": relative links would miss it
    Request request{path->substr(secret.size() + 2), {}};
    if (mark == std::string::npos) return {.request = request};
    for (const std::string& part : split(whole.substr(mark + 1), '&')) {
        const auto is = part.find('=');
        const auto name = decoded(part.substr(0, is));
        const auto value = decoded(is == std::string::npos ? "" : part.substr(is + 1));
        if (!name || !value) return {.refused = 400};
        request.query[*name] = *value;
    }
    return {.request = request};
}

#ifdef COURSE_HAS_HTTPLIB

namespace {

constexpr int most_viewers = 12;
constexpr auto heartbeat = std::chrono::seconds(1);  // soon it is known that a page has closed

void refuse(httplib::Response& response, int code, const std::string& why) {
    response.status = code;
    response.set_content(why + '\n', "text/plain; charset=utf-8");
}

}  // namespace

struct Server::Parts {
    explicit Parts(std::function<std::optional<Content>(const Request&)> answers)
        : answer{std::move(answers)} {
        // A thread for each page that waits for news, and some for all else.
        server.new_task_queue = [] { return new httplib::ThreadPool(most_viewers + 4); };
        // Then no byte of a request is taken for the next one. The library's own options would let
        // another program listen at the same port.
        server.set_keep_alive_max_count(1);
        server.set_socket_options([](auto) {});
        server.set_default_headers({{"Cache-Control", "no-store"},
                                    {"Referrer-Policy", "no-referrer"},
                                    {"Cross-Origin-Resource-Policy", "same-origin"},
                                    {"X-Content-Type-Options", "nosniff"}});
        server.set_pre_routing_handler([this](const auto& request, auto& response) {
            respond(request, response);
            return httplib::Server::HandlerResponse::Handled;
        });
        port = server.bind_to_any_port("127.0.0.1");
        if (port <= 0) throw app::Failure("no port of this machine is free for the page");
        listening = std::thread{[this] { server.listen_after_bind(); }};
        while (!server.is_running()) std::this_thread::yield();
    }

    ~Parts() {
        {
            const std::lock_guard lock{noting};
            ends = true;
        }
        news_came.notify_all();
        server.stop();
        listening.join();
    }

    bool is_own(const std::string& host) const {
        const std::string number = ':' + std::to_string(port);
        return host == "127.0.0.1" + number || host == "localhost" + number;
    }

    void respond(const httplib::Request& request, httplib::Response& response) {
        if (!is_own(request.get_header_value("Host")))
            return refuse(response, 403, "This is another host.");
        if (request.method != "GET" && request.method != "HEAD") {
            response.set_header("Allow", "GET, HEAD");
            return refuse(response, 405, "Pages can be read, and no more.");
        }
        const std::string http = "http://", origin = request.get_header_value("Origin");
        if (request.has_header("Origin") &&
            !(origin.rfind(http, 0) == 0 && is_own(origin.substr(http.size()))))
            return refuse(response, 403, "This page is for nobody but its reader.");
        const Asked asked = read_target(request.target, secret);
        if (asked.refused == 400) return refuse(response, 400, "This is no address of a page.");
        if (asked.refused == 403)
            return refuse(response, 403, "Open the address that ./course watch says.");
        if (asked.request && asked.request->path == "news" && request.method == "GET")
            return send_news(response);
        const auto content = asked.request ? answer(*asked.request) : std::nullopt;
        if (!content) return refuse(response, 404, "There is no such page.");
        response.set_header("Content-Security-Policy",
                            "default-src 'self' data: blob:; script-src " + content->scripts +
                                "; style-src " + content->scripts +
                                "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
        response.set_content(content->bytes, content->type);
    }

    // Lines that a page's EventSource reads, until the page closes.
    void send_news(httplib::Response& response) {
        if (viewers >= most_viewers) return refuse(response, 503, "Too many pages are open.");
        ++viewers;
        const auto seen = std::make_shared<int>(-1);
        response.set_chunked_content_provider(
            "text/event-stream",
            [this, seen](std::size_t, httplib::DataSink& sink) {
                std::unique_lock lock{noting};
                news_came.wait_for(lock, *seen < 0 ? heartbeat * 0 : heartbeat,
                                   [&] { return ends || *seen != news; });
                if (ends) return false;
                const std::string line =
                    *seen == news ? ":\n\n" : "data: " + std::to_string(news) + "\n\n";
                *seen = news;
                lock.unlock();
                return sink.write(line.data(), line.size());
            },
            [this](bool) { --viewers; });
    }

    std::function<std::optional<Content>(const Request&)> answer;
    const std::string secret = new_secret();
    httplib::Server server;
    int port = 0;
    std::atomic<int> viewers = 0;
    std::mutex noting;
    std::condition_variable news_came;
    int news = 0;
    bool ends = false;
    std::thread listening;
};

Server::Server(std::function<std::optional<Content>(const Request&)> answer)
    : parts_{std::make_unique<Parts>(std::move(answer))} {}
Server::~Server() = default;

bool Server::is_possible() {
    return true;
}
std::string Server::address() const {
    return "http://127.0.0.1:" + std::to_string(parts_->port) + '/' + parts_->secret + '/';
}
void Server::tell_news() {
    {
        const std::lock_guard lock{parts_->noting};
        ++parts_->news;
    }
    parts_->news_came.notify_all();
}
int Server::viewers() const {
    return parts_->viewers;
}

#else

struct Server::Parts {};

Server::Server(std::function<std::optional<Content>(const Request&)>) {
    throw app::Failure("this ./course was built without cpp-httplib");
}
Server::~Server() = default;

bool Server::is_possible() {
    return false;
}
std::string Server::address() const {
    return {};
}
void Server::tell_news() {}
int Server::viewers() const {
    return 0;
}

#endif

}  // namespace companion
