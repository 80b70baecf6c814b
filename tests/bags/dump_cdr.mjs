// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Describes messages in CDR, which come as write_cdr.mjs gives them, by the definitions of ROS 2.
import common from "@foxglove/rosmsg-msgs-common";
import { MessageReader } from "@foxglove/rosmsg2-serialization";

import { linesOf, print, readLines } from "./messages.mjs";

const readers = new Map();

function readerOf(type) {
  const plain = type.replace("/msg/", "/");
  if (!readers.has(plain)) {
    const library = Object.values(common.ros2jazzy).filter(({ name }) => name !== plain);
    const root = common.ros2jazzy[plain];
    readers.set(plain, root && new MessageReader([{ definitions: root.definitions }, ...library]));
  }
  return readers.get(plain);
}

for await (const { topic, type, log_time_ns, base64 } of readLines()) {
  const reader = readerOf(type);
  if (!reader) continue;
  const message = reader.readMessage(Buffer.from(base64, "base64"));
  for (const line of linesOf(topic, type, log_time_ns, message)) print(line);
}
