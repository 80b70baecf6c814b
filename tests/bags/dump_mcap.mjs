// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Describes an MCAP file's messages: node dump_mcap.mjs FILE
import { readFile } from "node:fs/promises";

import { parse } from "@foxglove/rosmsg";
import { MessageReader as Ros1Reader } from "@foxglove/rosmsg-serialization";
import { MessageReader as Ros2Reader } from "@foxglove/rosmsg2-serialization";
import zstd from "@foxglove/wasm-zstd";
import { McapStreamReader } from "@mcap/core";
import lz4 from "lz4js";

import { linesOf, print } from "./messages.mjs";

await zstd.isLoaded;
const mcap = new McapStreamReader({
  decompressHandlers: {
    lz4: (bytes) => lz4.decompress(bytes),
    zstd: (bytes, numBytes) => zstd.decompress(bytes, Number(numBytes)),
  },
});
let bytes = await readFile(process.argv[2]);
if (bytes.subarray(0, 4).equals(Buffer.from([0x28, 0xb5, 0x2f, 0xfd]))) {
  bytes = zstd.decompress(bytes, 1 << 28);
}
mcap.append(bytes);

const schemas = new Map();
const channels = new Map();

function readerOf({ messageEncoding }, { data }) {
  const text = new TextDecoder().decode(data);
  if (messageEncoding === "ros1") return new Ros1Reader(parse(text));
  return messageEncoding === "cdr" ? new Ros2Reader(parse(text, { ros2: true })) : undefined;
}

for (let record = mcap.nextRecord(); record; record = mcap.nextRecord()) {
  if (record.type === "Schema") schemas.set(record.id, record);
  if (record.type === "Channel" && !channels.has(record.id)) {
    const schema = schemas.get(record.schemaId);
    const isUnderstood = schema && ["ros1msg", "ros2msg"].includes(schema.encoding);
    const reader = isUnderstood ? readerOf(record, schema) : undefined;
    channels.set(record.id, { topic: record.topic, type: schema?.name, reader });
  }
  if (record.type !== "Message") continue;
  const { topic, type, reader } = channels.get(record.channelId);
  if (!reader) continue;
  const message = reader.readMessage(record.data);
  for (const line of linesOf(topic, type, record.logTime, message)) print(line);
}
