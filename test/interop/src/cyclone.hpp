// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <dds/dds.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace tocsin::interop {

/// The entity, or an exception with the reason.
[[nodiscard]] inline dds_entity_t checked(dds_entity_t entity) {
  if (entity < 0) throw std::runtime_error(std::string("Cyclone DDS: ") + dds_strretcode(-entity));
  return entity;
}

/// Takes all that waits, and calls `use` with each sample that is one.
template <class Message, class Use>
void take_all(dds_entity_t reader, const Use& use) {
  void* sample = nullptr;
  dds_sample_info_t info{};
  while (dds_take(reader, &sample, &info, 1, 1) == 1) {
    if (info.valid_data) use(*static_cast<const Message*>(sample));
    (void)dds_return_loan(reader, &sample, 1);
    sample = nullptr;
  }
}

/// A participant of Cyclone DDS, with default settings unless `qos` says others, and all that was
/// made with it.
class CycloneParticipant {
 public:
  using Qos = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

  explicit CycloneParticipant(int domain, const Qos& qos = {nullptr, dds_delete_qos})
      : entity_(checked(
            dds_create_participant(static_cast<dds_domainid_t>(domain), qos.get(), nullptr))) {}
  ~CycloneParticipant() { (void)dds_delete(entity_); }
  CycloneParticipant(const CycloneParticipant&) = delete;
  CycloneParticipant& operator=(const CycloneParticipant&) = delete;

  [[nodiscard]] dds_entity_t entity() const { return entity_; }
  [[nodiscard]] static Qos qos() { return {dds_create_qos(), dds_delete_qos}; }
  /// `name` as on the wire, `type_name` in place of the one that idlc made.
  [[nodiscard]] dds_entity_t topic(const dds_topic_descriptor_t& type, const std::string& name,
                                   const std::string& type_name) const {
    dds_topic_descriptor_t renamed = type;
    renamed.m_typename = type_name.c_str();
    return checked(dds_create_topic(entity_, &renamed, name.c_str(), nullptr, nullptr));
  }
  [[nodiscard]] dds_entity_t reader(dds_entity_t topic, const Qos& qos) const {
    return checked(dds_create_reader(entity_, topic, qos.get(), nullptr));
  }
  [[nodiscard]] dds_entity_t writer(dds_entity_t topic, const Qos& qos) const {
    return checked(dds_create_writer(entity_, topic, qos.get(), nullptr));
  }

 private:
  dds_entity_t entity_;
};

}  // namespace tocsin::interop
