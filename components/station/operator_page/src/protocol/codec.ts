// SPDX-License-Identifier: Apache-2.0
// Messages from and to CDR, by the text of their schema (ros2msg), as the server tells it.
import { parse } from "@foxglove/rosmsg";
import { MessageReader, MessageWriter } from "@foxglove/rosmsg2-serialization";

/** What a channel says of its type. */
export interface Schema {
  readonly name: string;
  readonly encoding: string;
  readonly text: string;
}

/** Throws when the bytes do not hold such a message. */
export type Decode = (data: ArrayBufferView) => unknown;
export type Encode = (message: unknown) => Uint8Array;

/** None for an encoding that is not known here. Throws when the text cannot be read. */
export function decoderOf(schema: Schema): Decode | undefined {
  if (schema.encoding !== "ros2msg") return undefined;
  const reader = new MessageReader(parse(schema.text, { ros2: true }));
  return (data) => reader.readMessage(data);
}

/** Of a ros2msg text. Fields that the message lacks are written as zero. */
export function encoderOf(text: string): Encode {
  const writer = new MessageWriter(parse(text, { ros2: true }));
  return (message) => writer.writeMessage(message);
}
