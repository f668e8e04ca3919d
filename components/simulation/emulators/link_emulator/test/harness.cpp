// SPDX-License-Identifier: Apache-2.0
#include "harness.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/capability.h>
#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "foundation/datagram_socket.hpp"

namespace tocsin::link {
namespace {

struct Made {
  std::string missing;
  int uxv = -1;
  int gcs = -1;
  int second_uxv = -1;
};

void write_file(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

bool enter_user_namespace() {
  const std::string uid = std::to_string(::getuid());
  const std::string gid = std::to_string(::getgid());
  if (::unshare(CLONE_NEWUSER) != 0) return false;
  write_file("/proc/self/setgroups", "deny");
  write_file("/proc/self/uid_map", "0 " + uid + " 1");
  write_file("/proc/self/gid_map", "0 " + gid + " 1");
  return true;
}

int new_namespace() {
  if (::unshare(CLONE_NEWNET) != 0) return -1;
  return ::open("/proc/self/ns/net", O_RDONLY);  // inherited by the program on purpose
}

Made make() {
  const bool own_user = std::getenv("TOCSIN_TEST_USERNS") != nullptr || ::geteuid() != 0;
  if (own_user && !enter_user_namespace()) {
    return {std::string("no user namespaces here: ") + std::strerror(errno)};
  }
  Made made{"", new_namespace(), new_namespace(), new_namespace()};
  if (made.second_uxv < 0) made.missing = "no network namespaces here";
  const int tun = ::open("/dev/net/tun", O_RDWR | O_CLOEXEC);
  if (tun < 0) made.missing = std::string("no /dev/net/tun here: ") + std::strerror(errno);
  if (tun >= 0) ::close(tun);
  return made;
}

const Made& made() {
  static const Made instance = make();
  return instance;
}

std::string path_of(int fd) { return "/proc/self/fd/" + std::to_string(fd); }

/// A socket that lives in the namespace.
int socket_in(const std::string& netns) {
  const int home = ::open("/proc/self/ns/net", O_RDONLY | O_CLOEXEC);
  const int target = ::open(netns.c_str(), O_RDONLY | O_CLOEXEC);
  (void)::setns(target, CLONE_NEWNET);
  const int fd = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  (void)::setns(home, CLONE_NEWNET);
  ::close(target);
  ::close(home);
  return fd;
}

sockaddr_in port_5000(const std::string& address) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_port = htons(5000);
  inet_pton(AF_INET, address.c_str(), &result.sin_addr);
  return result;
}

bool within_five_seconds(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    ::usleep(5000);
  }
  return false;
}

std::vector<char*> argv_of(std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return argv;
}

int lines_in(const std::string& path) {
  std::ifstream file(path);
  int lines = 0;
  for (std::string line; std::getline(file, line);) ++lines;
  return lines;
}

}  // namespace

const std::string& Namespaces::missing() { return made().missing; }
std::string Namespaces::uxv() { return path_of(made().uxv); }
std::string Namespaces::second_uxv() { return path_of(made().second_uxv); }
std::string Namespaces::gcs() { return path_of(made().gcs); }

UdpSocket::UdpSocket(const std::string& netns, const std::string& address, const std::string& peer)
    : fd_(socket_in(netns)) {
  const sockaddr_in here = port_5000(address);
  const sockaddr_in there = port_5000(peer);
  const int buffer = 4 << 20;
  ::setsockopt(fd_, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  (void)::bind(fd_, reinterpret_cast<const sockaddr*>(&here), sizeof here);
  (void)::connect(fd_, reinterpret_cast<const sockaddr*>(&there), sizeof there);
}

UdpSocket::~UdpSocket() { ::close(fd_); }

void UdpSocket::set_dscp(int dscp) {
  const int tos = dscp << 2;
  (void)::setsockopt(fd_, IPPROTO_IP, IP_TOS, &tos, sizeof tos);
}

void UdpSocket::send(int number, std::size_t bytes) {
  std::vector<char> data(std::max(bytes, sizeof number));
  std::memcpy(data.data(), &number, sizeof number);
  (void)::send(fd_, data.data(), data.size(), 0);
}

std::optional<int> UdpSocket::receive(int timeout_ms) {
  pollfd waiting{fd_, POLLIN, 0};
  if (::poll(&waiting, 1, timeout_ms) <= 0) return std::nullopt;
  int number = 0;
  if (::recv(fd_, &number, sizeof number, MSG_TRUNC) < 4) return std::nullopt;
  return number;
}

InterfaceState interface_state(const std::string& netns) {
  const int fd = socket_in(netns);
  ifreq request{};
  std::strcpy(request.ifr_name, "wlan0");
  InterfaceState state{::ioctl(fd, SIOCGIFFLAGS, &request) == 0, false, ""};
  state.carrier = state.exists && (request.ifr_flags & IFF_RUNNING) != 0;
  if (::ioctl(fd, SIOCGIFADDR, &request) == 0) {
    sockaddr_in address{};
    std::memcpy(&address, &request.ifr_addr, sizeof address);
    char text[INET_ADDRSTRLEN];
    state.address = inet_ntop(AF_INET, &address.sin_addr, text, sizeof text);
  }
  ::close(fd);
  return state;
}

bool loses_carrier(const std::string& netns) {
  return within_five_seconds([&netns] { return !interface_state(netns).carrier; });
}

bool delete_interface(const std::string& netns) {
  const pid_t child = ::fork();
  if (child == 0) {
    const int target = ::open(netns.c_str(), O_RDONLY | O_CLOEXEC);
    if (::setns(target, CLONE_NEWNET) == 0) {
      ::execlp("ip", "ip", "link", "delete", "wlan0", static_cast<char*>(nullptr));
    }
    ::_exit(127);
  }
  int status = 0;
  return ::waitpid(child, &status, 0) == child && status == 0;
}

Emulator::Emulator(const std::string& channel, Third third) : third_(third) {
  write_file(file("channel.yaml"), channel);
  start();
}

std::vector<std::string> Emulator::words() const {
  const bool two = third_ == Third::vehicle;
  const std::string start = two ? "{vehicle}_" : "";
  std::vector<std::string> words{LINK_EMULATOR, "--channel", file("channel.yaml"), "--seed", "5"};
  std::vector<std::string> ends{"uxv:" + Namespaces::uxv() + ":10.77.0.1/24",
                                "gcs:" + Namespaces::gcs() + ":10.77.0.2/24"};
  const std::string third = Namespaces::second_uxv() + ":10.77.0.3/24";
  if (two) ends.push_back("uxv2:" + third);
  for (const std::string& end : ends) words.insert(words.end(), {"--end", end});
  if (third_ == Third::station) words.insert(words.end(), {"--site", "south:" + third});
  for (const char* const name : {"control", "stats", "wireless"}) {
    words.insert(words.end(), {"--" + std::string(name), file(start + name)});
  }
  return words;
}

void Emulator::start() {
  std::vector<std::string> arguments = words();
  ::unlink(file("wireless").c_str());
  pid_ = ::fork();
  if (pid_ != 0) return;
  ::execv(LINK_EMULATOR, argv_of(arguments).data());
  ::_exit(127);
}

Emulator::~Emulator() {
  if (pid_ > 0) {
    signal(SIGKILL);
    wait();
  }
}

bool Emulator::ready() const {
  return within_five_seconds([this] {
    const bool two = third_ == Third::vehicle;
    return ::access(file(two ? "uxv2_wireless" : "wireless").c_str(), F_OK) == 0 &&
           interface_state(Namespaces::uxv()).carrier &&
           interface_state(Namespaces::gcs()).carrier &&
           (third_ == Third::none || interface_state(Namespaces::second_uxv()).carrier);
  });
}

void Emulator::command(const std::string& text, const std::string& socket) const {
  (void)DatagramSocket().send(file(socket), text);
}

void Emulator::signal(int number) const { ::kill(pid_, number); }

int Emulator::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

nlohmann::json Emulator::next_stats() const {
  const int seen = lines_in(file("stats"));
  if (!within_five_seconds([&] { return lines_in(file("stats")) > seen; })) return nullptr;
  std::ifstream stats(file("stats"));
  std::string last;
  for (std::string line; std::getline(stats, line);) last = line;
  return nlohmann::json::parse(last);
}

double Emulator::cpu_s() const {
  std::ifstream stat("/proc/" + std::to_string(pid_) + "/stat");
  std::string word;
  for (int field = 1; field < 14; ++field) stat >> word;  // proc(5): 14 utime, 15 stime
  double user = 0;
  double system = 0;
  stat >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string Emulator::file(const std::string& name) const { return folder_.path(name); }

ProgramEnd run_to_end(std::vector<std::string> arguments, bool without_privilege) {
  arguments.insert(arguments.begin(), LINK_EMULATOR);
  int pipe_fds[2];
  (void)!::pipe(pipe_fds);
  const pid_t pid = ::fork();
  if (pid == 0) {
    ::dup2(pipe_fds[1], STDERR_FILENO);
    ::close(pipe_fds[0]);
    ::close(pipe_fds[1]);
    if (without_privilege) ::prctl(PR_CAPBSET_DROP, CAP_SYS_ADMIN, 0, 0, 0);
    ::execv(LINK_EMULATOR, argv_of(arguments).data());
    ::_exit(127);
  }
  ::close(pipe_fds[1]);
  ProgramEnd end{0, ""};
  char buffer[512];
  for (ssize_t n = 0; (n = ::read(pipe_fds[0], buffer, sizeof buffer)) > 0;) {
    end.text.append(buffer, static_cast<std::size_t>(n));
  }
  ::close(pipe_fds[0]);
  int status = 0;
  ::waitpid(pid, &status, 0);
  end.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return end;
}

}  // namespace tocsin::link
