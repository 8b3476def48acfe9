#pragma once
// Shows pages to a browser on this machine, and to nobody else.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace companion {

// What the server answers a request with.
struct Content {
    std::string type;  // "text/html; charset=utf-8"
    std::string bytes;
    std::string scripts = "'self'";  // from where the page may take scripts and styles
};

// A request that has passed all checks: "page.js?of=1" is the path "page.js" with the query
// {"of", "1"}.
struct Request {
    std::string path;
    std::map<std::string, std::string> query;
};

// A server on 127.0.0.1, at a port of its own choice. Its address contains a secret: without it,
// there is no answer. It answers only GET and HEAD, and only requests that name this server as
// their host and, if they come from a page, as its origin.
class Server {
  public:
    // `answer` gets what follows the secret in the address; nothing means that there is no such
    // page. Several threads call it at the same time. The path "news" is the server's own: what
    // tell() says. Throws app::Failure if no port can be had.
    explicit Server(std::function<std::optional<Content>(const Request&)> answer);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    // False if the course was built without the library for it.
    static bool is_possible();

    std::string address() const;

    // Tells all pages that are open and seen that there is something new.
    void tell_news();

    // How many such pages there are.
    int viewers() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

// The path and query after the secret, in the target of a request, "/SECRET/page.js?of=1"; or the
// code of the answer that refuses it: 400 if no browser asks so, 403 without the secret.
struct Asked {
    std::optional<Request> request = {};
    int refused = 0;
};
Asked read_target(const std::string& target, const std::string& secret);

}  // namespace companion
