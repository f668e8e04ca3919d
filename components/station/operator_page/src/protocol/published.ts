// SPDX-License-Identifier: Apache-2.0
// The topics that the page writes, with their types in ros2msg. A test compares them with idl/.

/** A topic that the page may write. */
export interface Published {
  readonly topic: string;
  readonly schemaName: string;
  readonly text: string;
}

const separator = `\n${"=".repeat(80)}\n`;
const parts = (...texts: string[]): string => texts.join(separator);

const time = "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec";
const vector = "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z";

export const emergencyStopRequest: Published = {
  topic: "emergency_stop/request",
  schemaName: "std_msgs/msg/Bool",
  text: "bool data",
};

export const teleopVelocity: Published = {
  topic: "teleop/cmd_vel",
  schemaName: "geometry_msgs/msg/TwistStamped",
  text: parts(
    "std_msgs/Header header\ngeometry_msgs/Twist twist",
    "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id",
    time,
    "MSG: geometry_msgs/Twist\ngeometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular",
    vector,
  ),
};

export const missionCommand: Published = {
  topic: "mission/command",
  schemaName: "std_msgs/msg/String",
  text: "string data",
};

/** Asks for the wheel, gives it, keeps it. */
export const driverRequest: Published = {
  topic: "teleop/request",
  schemaName: "tocsin_msgs/msg/DriverRequest",
  text: parts("builtin_interfaces/Time stamp\nstring name\nstring verb", time),
};

export const allPublished: readonly Published[] = [
  emergencyStopRequest,
  teleopVelocity,
  missionCommand,
  driverRequest,
];
