// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A viewer by others: subscribes to all that a server of the Foxglove protocol shows, decodes every
// message by the schema that was advertised with it, and prints what came as JSON, a line when it
// is connected and one at the end: node view_live.mjs PORT NUM_SCANS.
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";
import { WebSocket } from "ws";

const { FoxgloveClient } = protocol;

const [port, numScans] = process.argv.slice(2).map(Number);
const client = new FoxgloveClient({
  ws: new WebSocket(`ws://127.0.0.1:${port}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});
const channels = new Map();
const num = {};
const last = {};
const isDone = () =>
  (num["/scan"] ?? 0) >= numScans && num["/map"] && num["/path"] && num["/closures"];

client.on("error", (error) => {
  console.error(error);
  process.exit(1);
});
client.on("advertise", (added) => {
  for (const channel of added) {
    const reader = new MessageReader(parse(channel.schema, { ros2: true }));
    channels.set(client.subscribe(channel.id), { topic: channel.topic, reader });
  }
});
client.on("serverInfo", (info) => console.log(JSON.stringify(info)));
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const { topic, reader } = channels.get(subscriptionId);
  const message = reader.readMessage(data);
  num[topic] = (num[topic] ?? 0) + 1;
  last[topic] = { message, timestamp };
  if (isDone()) tell();
});

function tell() {
  const grid = last["/map"].message;
  const scan = last["/scan"].message;
  console.log(
    JSON.stringify({
      num,
      frames: last["/tf"].message.transforms.map((t) => [t.header.frame_id, t.child_frame_id]),
      numBeams: scan.ranges.length,
      stampAgrees:
        BigInt(scan.header.stamp.sec) * 1000000000n + BigInt(scan.header.stamp.nanosec) ===
        last["/scan"].timestamp,
      width: grid.info.width,
      height: grid.info.height,
      numFree: grid.data.filter((cell) => cell === 0).length,
      numOccupied: grid.data.filter((cell) => cell === 100).length,
      numPoses: last["/path"].message.poses.length,
      numMarkers: last["/closures"].message.markers.length,
    }),
  );
  process.exit(0);
}
setTimeout(() => {
  console.error(JSON.stringify(num));
  process.exit(3);
}, 100000);
