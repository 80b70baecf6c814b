// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Writes an MCAP file: node write_mcap.mjs ros1|cdr none|lz4|zstd FILE <LINES
import { open } from "node:fs/promises";

import zstd from "@foxglove/wasm-zstd";
import { McapWriter } from "@mcap/core";
import lz4 from "lz4js";

import { messageOf, readLines, writerOf } from "./messages.mjs";

const CHUNK_BYTES = 20000; // several chunks

const COMPRESSORS = {
  none: undefined,
  lz4: (bytes) => ({ compression: "lz4", compressedData: lz4.compress(bytes) }),
  zstd: (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes) }),
};

const [encoding, compression, path] = process.argv.slice(2);
await zstd.isLoaded;
const file = await open(path, "w");
let numBytes = 0n;
const writable = {
  position: () => numBytes,
  write: async (bytes) => {
    await file.write(bytes);
    numBytes += BigInt(bytes.byteLength);
  },
};
const mcap = new McapWriter({ writable, chunkSize: CHUNK_BYTES, compressChunk: COMPRESSORS[compression] });
await mcap.start({ profile: encoding === "ros1" ? "ros1" : "ros2", library: "" });

const channels = new Map();

async function channelOf(line) {
  const known = channels.get(line.topic);
  if (known) return known;
  const writer = writerOf(encoding, line.kind);
  const schemaId = await mcap.registerSchema({
    name: writer.type,
    encoding: encoding === "ros1" ? "ros1msg" : "ros2msg",
    data: new TextEncoder().encode(writer.definition),
  });
  const id = await mcap.registerChannel({
    topic: line.topic,
    messageEncoding: encoding,
    schemaId,
    metadata: new Map(),
  });
  const channel = { id, write: writer.write };
  channels.set(line.topic, channel);
  return channel;
}

let sequence = 0;
for await (const line of readLines()) {
  const channel = await channelOf(line);
  await mcap.addMessage({
    channelId: channel.id,
    sequence: sequence++,
    logTime: BigInt(line.log_time_ns),
    publishTime: BigInt(line.log_time_ns),
    data: channel.write(messageOf(line)),
  });
}
await mcap.end();
await file.close();
