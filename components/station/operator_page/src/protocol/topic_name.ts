// SPDX-License-Identifier: Apache-2.0

/** The name of a topic without ROS's leading slash. */
export const plainTopic = (topic: string): string => topic.replace(/^\//, "");

/** What all of a host share, whatever their namespace. */
const sharedTopics: ReadonlySet<string> = new Set(["rosout"]);

/** A topic or a service by its name in a namespace, "uxv1" or none; undefined: it is another vehicle's. */
export function nameIn(namespace: string, topic: string): string | undefined {
  const plain = plainTopic(topic);
  if (namespace === "" || sharedTopics.has(plain)) return plain;
  return plain.startsWith(`${namespace}/`) ? plain.slice(namespace.length + 1) : undefined;
}
