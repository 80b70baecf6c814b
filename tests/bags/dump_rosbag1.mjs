// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Describes a ROS 1 bag's messages: node dump_rosbag1.mjs FILE
import { Bag } from "@foxglove/rosbag";
import { FileReader } from "@foxglove/rosbag/node.js";
import Bzip2 from "@foxglove/wasm-bz2";
import lz4 from "lz4js";

import { linesOf, nanosecondsOf, print } from "./messages.mjs";

const bzip2 = await Bzip2.init();
const bag = new Bag(new FileReader(process.argv[2]), {
  decompress: {
    bz2: (bytes, numBytes) => bzip2.decompress(bytes, numBytes, { small: false }),
    lz4: (bytes) => lz4.decompress(bytes),
  },
});
await bag.open();
for await (const { topic, timestamp, connectionId, message } of bag.messageIterator()) {
  const { type } = bag.connections.get(connectionId);
  for (const line of linesOf(topic, type, nanosecondsOf(timestamp), message)) print(line);
}
