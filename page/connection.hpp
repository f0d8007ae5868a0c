// A connection of the page's server: it reads no more than a bounded request, within a bounded time. The HTTP
// library bounds neither heads nor bodies without a length.
#pragma once

#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <functional>
#include <utility>

namespace orbearing::page {

class Connection final : public httplib::Stream {
 public:
  Connection(socket_t socket, std::size_t largest_request, std::function<bool()> ending)
      : socket_(socket), left_(largest_request), ending_(std::move(ending)) {}

  bool is_readable() const override { return first_ < last_ || poll_for(POLLIN, 0); }
  bool is_writable() const override { return waits_for(POLLOUT, Clock::now() + patience) && !is_cut(); }

  // 0 at the end of what was sent, -1 behind the bounds.
  ssize_t read(char* into, std::size_t size) override {
    if (first_ == last_) {
      if (left_ == 0 || !waits_for(POLLIN, std::min(until_, Clock::now() + patience))) return -1;
      const ssize_t got = recv(socket_, buffer_.data(), std::min(buffer_.size(), left_), 0);
      if (got <= 0) return got;
      first_ = 0;
      last_ = static_cast<std::size_t>(got);
      left_ -= last_;
    }
    const std::size_t given = std::min(size, last_ - first_);
    std::memcpy(into, buffer_.data() + first_, given);
    first_ += given;
    return static_cast<ssize_t>(given);
  }

  ssize_t write(const char* from, std::size_t size) override {
    return waits_for(POLLOUT, Clock::now() + patience) ? send(socket_, from, size, MSG_NOSIGNAL) : -1;
  }

  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds patience{5};          // between two parts
  static constexpr std::chrono::seconds longest_reading{30};  // of a request

  bool poll_for(short event, int milliseconds) const {
    pollfd waiting{socket_, event, 0};
    return poll(&waiting, 1, milliseconds) > 0;
  }

  // In short steps, so that a program that ends does not wait for a silent connection.
  bool waits_for(short event, Clock::time_point until) const {
    constexpr int step = 100;  // [ms]
    while (!poll_for(event, step))
      if (ending_() || Clock::now() > until) return false;
    return true;
  }

  bool is_cut() const {
    char byte = 0;
    const ssize_t seen = recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return seen == 0 || (seen < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
  }

  socket_t socket_;
  std::size_t left_;  // bytes that may still be read
  std::function<bool()> ending_;
  Clock::time_point until_ = Clock::now() + longest_reading;
  std::array<char, 4096> buffer_{};
  std::size_t first_ = 0, last_ = 0;  // of the buffer, what was not taken yet
};

/// Each connection brings one request: an unread body is no further one.
class Server final : public httplib::Server {
 public:
  explicit Server(std::size_t largest_request) : largest_request_(largest_request) {}

 private:
  bool process_and_close_socket(socket_t socket) override {
    Connection connection(socket, largest_request_, [this] { return svr_sock_ == INVALID_SOCKET; });
    bool closed = false;
    const bool answered = process_request(connection, true, closed, nullptr);
    shutdown(socket, SHUT_RDWR);
    close(socket);
    return answered;
  }

  std::size_t largest_request_;
};

}  // namespace orbearing::page
