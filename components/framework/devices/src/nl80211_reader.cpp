// SPDX-License-Identifier: Apache-2.0
#include <linux/nl80211.h>
#include <net/if.h>
#include <netlink/genl/ctrl.h>
#include <netlink/genl/genl.h>
#include <netlink/netlink.h>

#include <cstdint>
#include <functional>
#include <memory>

#include "nl80211.hpp"

namespace tocsin::network {
namespace {

using Handler = std::function<void(nl_msg*)>;

int on_message(nl_msg* message, void* handler) {
  (*static_cast<Handler*>(handler))(message);
  return NL_OK;
}

struct MessageFree {
  void operator()(nl_msg* message) const { nlmsg_free(message); }
};
struct CallbackFree {
  void operator()(nl_cb* callback) const { nl_cb_put(callback); }
};

/// Sends one dump request and hands each answer to `handler`. Negative libnl error on failure.
int dump(nl_sock* socket, int family, std::pair<std::uint8_t, unsigned> command_and_interface,
         Handler handler) {
  const std::unique_ptr<nl_msg, MessageFree> request(nlmsg_alloc());
  const std::unique_ptr<nl_cb, CallbackFree> callback(nl_cb_alloc(NL_CB_DEFAULT));
  if (!request || !callback) return -NLE_NOMEM;
  const auto [command, interface] = command_and_interface;
  genlmsg_put(request.get(), NL_AUTO_PORT, NL_AUTO_SEQ, family, 0, NLM_F_DUMP, command, 0);
  nla_put_u32(request.get(), NL80211_ATTR_IFINDEX, interface);
  nl_cb_set(callback.get(), NL_CB_VALID, NL_CB_CUSTOM, on_message, &handler);
  const int sent = nl_send_auto(socket, request.get());
  return sent < 0 ? sent : nl_recvmsgs(socket, callback.get());
}

}  // namespace

Nl80211Reader::Nl80211Reader() : socket_(nl_socket_alloc()) {
  if (socket_ && genl_connect(socket_) == 0) family_ = genl_ctrl_resolve(socket_, "nl80211");
}

Nl80211Reader::~Nl80211Reader() { nl_socket_free(socket_); }

WirelessReading Nl80211Reader::read(const std::string& interface) {
  if (family_ < 0) return absent("this kernel has no nl80211");
  const unsigned index = if_nametoindex(interface.c_str());
  if (index == 0) return absent("there is no interface " + interface);
  std::optional<WirelessReading> reading;
  const int error =
      dump(socket_, family_, {NL80211_CMD_GET_STATION, index}, [&reading](nl_msg* message) {
        if (!reading) reading = parse_station(message);
      });
  if (error < 0) return absent(interface + " is not a wireless interface");
  if (!reading) {
    WirelessReading silent;
    silent.source = WirelessSource::nl80211;
    silent.note = "not associated";
    return silent;
  }
  // Many drivers have no survey: an error leaves its fields empty.
  (void)dump(socket_, family_, {NL80211_CMD_GET_SURVEY, index}, [&reading](nl_msg* message) {
    if (const auto survey = parse_survey(message)) add_survey(*survey, *reading);
  });
  return *reading;
}

}  // namespace tocsin::network
