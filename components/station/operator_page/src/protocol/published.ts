// SPDX-License-Identifier: Apache-2.0
// The topics that the page writes. Their types are printed from idl/ at build time: generated/.
import { PoseWithCovarianceStamped, TwistStamped } from "../../generated/geometry_msgs.ts";
import { Bool, String as Text } from "../../generated/std_msgs.ts";
import { DriverRequest } from "../../generated/tocsin_msgs.ts";

/** A topic that the page may write. */
export interface Published {
  readonly topic: string;
  readonly schemaName: string;
  /** The type in ros2msg. */
  readonly text: string;
}

export const emergencyStopRequest: Published = { topic: "emergency_stop/request", ...Bool };
export const teleopVelocity: Published = { topic: "teleop/cmd_vel", ...TwistStamped };
/** Where the vehicle is, as a person sees it. */
export const initialPose: Published = { topic: "initialpose", ...PoseWithCovarianceStamped };
export const missionCommand: Published = { topic: "mission/command", ...Text };
/** Asks for control, gives it, keeps it. */
export const driverRequest: Published = { topic: "teleop/request", ...DriverRequest };

export const allPublished: readonly Published[] = [emergencyStopRequest, teleopVelocity, initialPose, missionCommand, driverRequest];
