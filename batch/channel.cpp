// SPDX-License-Identifier: BSD-3-Clause
#include <eliminant/batch/channel.hpp>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

#include <eliminant/io/results/error_report.hpp>

namespace eliminant::batch {

Channel::Channel(int socket) : socket_(socket) {
  fcntl(socket_, F_SETFL, fcntl(socket_, F_GETFL) | O_NONBLOCK);
  fcntl(socket_, F_SETFD, FD_CLOEXEC);
}

Channel::~Channel() { close(socket_); }

short Channel::events() const { return static_cast<short>(unsent_.empty() ? POLLIN : POLLIN | POLLOUT); }

void Channel::send(const Frame& frame) {
  append_frame(frame, unsent_);
  flush();
}

bool Channel::flush() {
  while (sent_ < unsent_.size()) {
    const ssize_t count = write(socket_, unsent_.data() + sent_, unsent_.size() - sent_);
    if (count > 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      return errno == EAGAIN || errno == EWOULDBLOCK;
    }
  }
  unsent_.clear();
  sent_ = 0;
  return true;
}

bool Channel::fill() {
  static constexpr std::size_t block_size = std::size_t{1} << 16U;
  static thread_local const auto block = std::make_unique<char[]>(block_size);
  while (true) {
    const ssize_t count = read(socket_, block.get(), block_size);
    if (count > 0) {
      received_.add(block.get(), static_cast<std::size_t>(count));
      // Less than what was asked for: there is no more.
      if (static_cast<std::size_t>(count) < block_size) return true;
    } else if (count == 0) {
      return false;
    } else if (errno != EINTR) {
      return errno == EAGAIN || errno == EWOULDBLOCK;
    }
  }
}

void Channel::wait(short events) const {
  pollfd entry{socket_, events, 0};
  poll(&entry, 1, -1);
}

std::optional<Frame> Channel::wait_for_frame() {
  while (true) {
    if (auto frame = receive()) return frame;
    wait(POLLIN);
    if (!fill()) return receive();
  }
}

bool Channel::send_all(const Frame& frame) {
  append_frame(frame, unsent_);
  while (flush()) {
    if (unsent_.empty()) return true;
    wait(POLLOUT);
  }
  return false;
}

std::array<int, 2> connected_sockets() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0)
    throw io::OutputError("cannot connect to a worker process: " + std::string(std::strerror(errno)));
  return ends;
}

}  // namespace eliminant::batch
