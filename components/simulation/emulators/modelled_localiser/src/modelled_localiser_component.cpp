// SPDX-License-Identifier: Apache-2.0
#include "modelled_localiser/modelled_localiser_component.hpp"

#include "geometry/pose_message.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

// Of the localiser where it is lost, see Localiser::estimate.
constexpr double lost_m2 = 25;
constexpr double lost_rad2 = 3;

}  // namespace

ModelledLocaliserComponent::ModelledLocaliserComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      truth_(context.devices().open<TruePose>()),
      error_(params.error, context.seed) {}

void ModelledLocaliserComponent::tick(Time now) {
  const auto odom = odom_.take_latest();
  if (!odom || now < next_) return;
  const geometry::Pose pose = geometry::pose_in(odom->pose().pose());
  if (!is_finite(pose)) return;
  next_ = next_instant(seconds(1 / params_.rate_hz), now);
  tell(pose, odom->header().stamp(), now);
}

void ModelledLocaliserComponent::tell(const geometry::Pose& odom,
                                      const builtin_interfaces::msg::Time& stamp, Time now) {
  const auto pose = error_.read(truth_->read(), now);
  if (!pose) {
    return pose_.publish_pose(known_, {lost_m2, 0, 0, 0, lost_m2, 0, 0, 0, lost_rad2}, stamp);
  }
  known_ = *pose;
  const double m2 = params_.error.deviation_m * params_.error.deviation_m;
  const double rad2 = params_.error.deviation_rad * params_.error.deviation_rad;
  pose_.publish_pose(known_, {m2, 0, 0, 0, m2, 0, 0, 0, rad2}, stamp);
  pose_.publish_transform(compose(known_, inverse(odom)), stamp);
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::ModelledLocaliserComponent)
