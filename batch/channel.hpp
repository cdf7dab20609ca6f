// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include <eliminant/batch/frame.hpp>

namespace eliminant::batch {

/// Frames over one end of a socket, which never makes its user wait: what cannot be sent yet is kept.
class Channel {
 public:
  /// Takes the socket over.
  explicit Channel(int socket);
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel();

  int socket() const { return socket_; }
  /// What poll() is to wait for.
  short events() const;

  /// Sends now or with a later flush().
  void send(const Frame& frame);
  /// Sends what can be sent; false when the other end is closed.
  bool flush();
  /// Reads what has arrived; false when the other end is closed.
  bool fill();
  std::optional<Frame> receive() { return received_.next(); }

  /// These two wait; for a process that has nothing else to look after. nullopt, or false, at the end.
  std::optional<Frame> wait_for_frame();
  bool send_all(const Frame& frame);

 private:
  void wait(short events) const;

  int socket_;
  std::string unsent_;
  std::size_t sent_ = 0;
  FrameAssembly received_;
};

/// The two ends of a new connection. Throws io::OutputError when the system has no more of them.
std::array<int, 2> connected_sockets();

}  // namespace eliminant::batch
