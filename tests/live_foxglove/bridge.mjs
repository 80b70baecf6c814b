// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A bridge by others: serves the messages of an MCAP file by the Foxglove protocol, as a robot's
// foxglove_bridge does: node bridge.mjs FILE MESSAGES_PER_SECOND. Prints its port; begins when
// somebody subscribes to /scan, and ends behind the last message.
import { once } from "node:events";
import { open } from "node:fs/promises";

import zstd from "@foxglove/wasm-zstd";
import protocol from "@foxglove/ws-protocol";
import { McapIndexedReader } from "@mcap/core";
import { WebSocketServer } from "ws";

const { FoxgloveServer } = protocol;

await zstd.isLoaded;
const file = await open(process.argv[2], "r");
const rate = Number(process.argv[3]);
const mcap = await McapIndexedReader.Initialize({
  readable: {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, size) => {
      const bytes = new Uint8Array(Number(size));
      await file.read(bytes, 0, bytes.byteLength, Number(offset));
      return bytes;
    },
  },
  decompressHandlers: { zstd: (bytes, numBytes) => zstd.decompress(bytes, Number(numBytes)) },
});

const server = new FoxgloveServer({ name: "bridge", supportedEncodings: ["cdr"] });
const sockets = new WebSocketServer({
  host: "127.0.0.1",
  port: 0,
  handleProtocols: (protocols) => server.handleProtocols(protocols),
});
sockets.on("connection", (connection) => server.handleConnection(connection, "live"));
await once(sockets, "listening");
console.log(sockets.address().port);

const ids = new Map();
for (const [id, channel] of mcap.channelsById) {
  const schema = mcap.schemasById.get(channel.schemaId);
  ids.set(
    id,
    server.addChannel({
      topic: channel.topic,
      encoding: "cdr",
      schemaName: schema.name,
      schema: new TextDecoder().decode(schema.data),
      schemaEncoding: "ros2msg",
    }),
  );
}
const scans = [...mcap.channelsById.values()].find((channel) => channel.topic === "/scan");
const isSubscribed = new Promise((resolve) => {
  server.on("subscribe", (id) => {
    if (id === ids.get(scans.id)) setTimeout(resolve, 300); // to the others, too
  });
});
await isSubscribed;
let num = 0;
for await (const message of mcap.readMessages()) {
  server.sendMessage(ids.get(message.channelId), message.logTime, message.data);
  if (++num % 10 === 0) await new Promise((resolve) => setTimeout(resolve, 10000 / rate));
}
setTimeout(() => process.exit(0), 1500);
