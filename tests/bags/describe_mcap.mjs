// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Reads an MCAP file by its index, as viewers do, and decodes every message by its own schema:
// node describe_mcap.mjs FILE. Prints a line per topic: {topic, type, num, stamps_ascend, last} with
// the last message, its long arrays as their lengths and sums.
import { open } from "node:fs/promises";

import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import zstd from "@foxglove/wasm-zstd";
import { McapIndexedReader } from "@mcap/core";
import lz4 from "lz4js";

import { print } from "./messages.mjs";

const LONGEST_SHOWN = 8;

await zstd.isLoaded;
const file = await open(process.argv[2], "r");
const readable = {
  size: async () => BigInt((await file.stat()).size),
  read: async (offset, size) => {
    const bytes = new Uint8Array(Number(size));
    await file.read(bytes, 0, bytes.byteLength, Number(offset));
    return bytes;
  },
};
const mcap = await McapIndexedReader.Initialize({
  readable,
  decompressHandlers: {
    lz4: (bytes) => lz4.decompress(bytes),
    zstd: (bytes, numBytes) => zstd.decompress(bytes, Number(numBytes)),
  },
});

function readerOf(channel) {
  const { encoding, data } = mcap.schemasById.get(channel.schemaId);
  if (encoding !== "ros2msg" || channel.messageEncoding !== "cdr") {
    throw new Error(`${channel.topic}: ${encoding}, ${channel.messageEncoding}`);
  }
  return new MessageReader(parse(new TextDecoder().decode(data), { ros2: true }));
}

function shown(name, value) {
  if (typeof value === "bigint") return String(value);
  if (!ArrayBuffer.isView(value) || value.length <= LONGEST_SHOWN) {
    return ArrayBuffer.isView(value) ? Array.from(value) : value;
  }
  return { length: value.length, sum: value.reduce((sum, number) => sum + Number(number), 0) };
}

const topics = new Map();
for (const channel of mcap.channelsById.values()) {
  const { name } = mcap.schemasById.get(channel.schemaId);
  topics.set(channel.id, { topic: channel.topic, type: name, reader: readerOf(channel), num: 0,
                           stamps_ascend: true, last_ns: 0n });
}
for await (const { channelId, data, logTime } of mcap.readMessages()) {
  const topic = topics.get(channelId);
  topic.last = topic.reader.readMessage(data);
  topic.num += 1;
  topic.stamps_ascend &&= logTime >= topic.last_ns;
  topic.last_ns = logTime;
}
for (const { reader, last_ns: lastNs, ...line } of topics.values()) {
  print(JSON.parse(JSON.stringify({ ...line, last_ns: lastNs }, shown)));
}
await file.close();
