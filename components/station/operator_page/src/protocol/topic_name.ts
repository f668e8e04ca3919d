// SPDX-License-Identifier: Apache-2.0

/** The name of a topic without ROS's leading slash. */
export const plainTopic = (topic: string): string => topic.replace(/^\//, "");
