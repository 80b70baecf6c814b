// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// A node by others: subscribes to what live mapping publishes by an implementation of RTPS in
// TypeScript, decodes every message, and prints what came as JSON when its standard input has ended:
// node rtps_peer.mjs DOMAIN. On the loopback device alone.
import dgram from "node:dgram";

import common from "@foxglove/rosmsg-msgs-common";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import rtps from "@foxglove/rtps";
import nodejs from "@foxglove/rtps/nodejs";

const LOOPBACK = "127.0.0.1";
const LATCHED = { durability: rtps.Durability.TransientLocal, depth: 1 };
const FOLLOWED = { durability: rtps.Durability.Volatile, depth: 100 };
const TOPICS = {
  "rt/map": ["nav_msgs", "OccupancyGrid", LATCHED],
  "rt/path": ["nav_msgs", "Path", LATCHED],
  "rt/pose": ["geometry_msgs", "PoseWithCovarianceStamped", FOLLOWED],
  "rt/tf": ["tf2_msgs", "TFMessage", FOLLOWED],
};

/** Every type that one is made of, itself first. */
function definitionsOf(name, all = new Map()) {
  const definition = common.ros2humble[name];
  if (all.has(name) || definition === undefined) return all;
  all.set(name, definition);
  for (const { type, isComplex } of definition.definitions) if (isComplex) definitionsOf(type, all);
  return all;
}

const num = {};
const last = {};
const readers = Object.fromEntries(
  Object.entries(TOPICS).map(([topic, [folder, type]]) => [
    topic,
    new MessageReader([...definitionsOf(`${folder}/${type}`).values()]),
  ]),
);

async function socketOn(options) {
  const socket = new nodejs.UdpSocketNode(dgram.createSocket({ ...options, reuseAddr: true }));
  const bind = socket.bind.bind(socket);
  socket.bind = async (where) => {
    await bind(where);
    await socket.setMulticastInterface(LOOPBACK);
  };
  const join = socket.addMembership.bind(socket);
  socket.addMembership = (group) => join(group, LOOPBACK);
  return socket;
}

const participant = new rtps.Participant({
  name: "rtps_peer",
  addresses: [LOOPBACK],
  domainId: Number(process.argv[2]),
  udpSocketCreate: socketOn,
});
participant.on("error", (error) => console.error(error));
const missing = new Set(Object.keys(TOPICS));
participant.on("discoveredPublication", ({ topicName }) => {
  if (missing.delete(topicName) && missing.size === 0) console.log("all are there");
});
participant.on("userData", ({ subscription, serializedData }) => {
  const topic = subscription.topicName;
  num[topic] = (num[topic] ?? 0) + 1;
  last[topic] = readers[topic].readMessage(serializedData);
});
await participant.start();
for (const [topicName, [folder, type, { durability, depth }]] of Object.entries(TOPICS)) {
  participant.subscribe({
    topicName,
    typeName: `${folder}::msg::dds_::${type}_`,
    durability,
    reliability: { kind: rtps.Reliability.Reliable, maxBlockingTime: { sec: 0, nsec: 0 } },
    history: { kind: rtps.HistoryKind.KeepLast, depth },
  });
}

function tell() {
  const cells = last["rt/map"]?.data ?? [];
  console.log(
    JSON.stringify({
      num,
      numFree: cells.filter((cell) => cell === 0).length,
      numOccupied: cells.filter((cell) => cell === 100).length,
      pose: last["rt/pose"]?.pose.pose.position,
      frames: last["rt/tf"]?.transforms.map((t) => [t.header.frame_id, t.child_frame_id]),
      numPoses: last["rt/path"]?.poses.length,
    }),
  );
  process.exit(0);
}
process.stdin.on("end", () => setTimeout(tell, 1000)); // For what is on its way.
process.stdin.resume();
