// SPDX-License-Identifier: Apache-2.0
#include "telemetry/telemetry_component.hpp"

#include <limits>
#include <utility>

#include "runtime/component_entry.hpp"
#include "telemetry/memory.hpp"

namespace tocsin {
namespace {

std::optional<telemetry::Thermometer> find_thermometer(DeviceFiles& files,
                                                       const TelemetryComponent::Params& params) {
  return telemetry::choose_cpu_thermometer(
      telemetry::list_thermometers(files, params.thermal_dir, params.hwmon_dir));
}

}  // namespace

TelemetryComponent::TelemetryComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      files_(context.devices().open<DeviceFiles>()),
      thermometer_(find_thermometer(*files_, params)) {
  wake_every(seconds(params.period_s));
}

void TelemetryComponent::tick(Time now) {
  report_memory(now);
  report_load(now);
  report_temperature(now);
}

void TelemetryComponent::report_memory(Time now) {
  const auto text = files_->read(params_.meminfo_file);
  const auto memory = text ? telemetry::parse_meminfo(*text) : std::nullopt;
  if (!memory) return say_once(params_.meminfo_file + " does not tell the memory");
  topic::MemoryUsage::Message message;
  message.stamp(wall(now));
  message.total_bytes(memory->total_bytes);
  message.available_bytes(memory->available_bytes);
  message.used_percent(static_cast<float>(memory->used_percent()));
  if (memory_.write(std::move(message)) == Status::failed) log().warn("memory was not sent");
}

void TelemetryComponent::report_load(Time now) {
  const auto text = files_->read(params_.stat_file);
  const auto snapshot = text ? telemetry::parse_proc_stat(*text) : std::nullopt;
  if (!snapshot) return say_once(params_.stat_file + " does not tell the CPU load");
  const auto load = meter_.update(*snapshot);
  if (!load) return;
  topic::CpuLoad::Message message;
  message.stamp(wall(now));
  message.load_percent(static_cast<float>(load->all_percent));
  message.core_percent({load->cores_percent.begin(), load->cores_percent.end()});
  if (load_.write(std::move(message)) == Status::failed) log().warn("CPU load was not sent");
}

void TelemetryComponent::report_temperature(Time now) {
  const auto text = thermometer_ ? files_->read(thermometer_->file) : std::nullopt;
  const auto degrees = text ? telemetry::parse_temperature(*text) : std::nullopt;
  if (!thermometer_) say_once("this computer has no CPU thermometer");
  if (thermometer_ && !degrees) say_once(thermometer_->file + " does not tell a temperature");
  topic::CpuTemperature::Message message;
  message.header().stamp(wall(now));
  message.header().frame_id(thermometer_ ? thermometer_->name : "absent");
  message.temperature(degrees.value_or(std::numeric_limits<double>::quiet_NaN()));
  if (temperature_.write(std::move(message)) == Status::failed) {
    log().warn("CPU temperature was not sent");
  }
}

void TelemetryComponent::say_once(const std::string& text) {
  if (said_.insert(text).second) log().warn("{}", text);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::TelemetryComponent)
