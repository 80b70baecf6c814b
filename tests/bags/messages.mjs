// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
// Between the lines of made_recording.py and messages of ROS 1 and ROS 2, by the packages of others.
import { createInterface } from "node:readline";

import { stringify } from "@foxglove/rosmsg";
import common from "@foxglove/rosmsg-msgs-common";
import { MessageWriter as Ros1Writer } from "@foxglove/rosmsg-serialization";
import { MessageWriter as Ros2Writer } from "@foxglove/rosmsg2-serialization";

const TYPES = {
  scan: "sensor_msgs/LaserScan",
  odometry: "nav_msgs/Odometry",
  transform: "tf2_msgs/TFMessage",
};
const SCAN_NUMBERS = ["angle_min", "angle_max", "angle_increment", "time_increment", "scan_time",
                      "range_min", "range_max"];

const NOT_KNOWN = new Float64Array(36); // a covariance

export const NS_PER_S = 1000000000n;

export function timeOf(text) {
  const ns = BigInt(text);
  return { sec: Number(ns / NS_PER_S), nsec: Number(ns % NS_PER_S) };
}

export function nanosecondsOf({ sec, nsec, nanosec }) {
  return String(BigInt(sec) * NS_PER_S + BigInt(nsec ?? nanosec));
}

function quaternionOf(yaw) {
  return { x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) };
}

function yawOf({ x, y, z, w }) {
  return Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
}

function numberOf(text) {
  return { inf: Infinity, "-inf": -Infinity, nan: NaN }[text] ?? text;
}

function textOf(number) {
  if (Number.isFinite(number)) return number;
  return Number.isNaN(number) ? "nan" : number > 0 ? "inf" : "-inf";
}

// The message that a line describes.
export function messageOf(line) {
  const header = { seq: 0, stamp: timeOf(line.stamp_ns), frame_id: line.frame };
  if (line.kind === "scan") {
    const scan = { header, ranges: line.ranges.map(numberOf), intensities: [] };
    for (const name of SCAN_NUMBERS) scan[name] = line[name];
    return scan;
  }
  const position = { x: line.x, y: line.y, z: 0 };
  const rotation = quaternionOf(line.yaw);
  if (line.kind === "odometry") {
    const pose = { pose: { position, orientation: rotation }, covariance: NOT_KNOWN };
    const zero = { x: 0, y: 0, z: 0 };
    const twist = { twist: { linear: zero, angular: zero }, covariance: NOT_KNOWN };
    return { header, child_frame_id: line.child_frame, pose, twist };
  }
  const transform = { translation: position, rotation };
  return { transforms: [{ header, child_frame_id: line.child_frame, transform }] };
}

// The lines that describe a message of one of the three types; none for other types.
export function linesOf(topic, type, logTimeNs, message) {
  const plain = type.replace("/msg/", "/");
  const about = (kind, part) => ({
    kind,
    topic,
    log_time_ns: String(logTimeNs),
    stamp_ns: nanosecondsOf(part.header.stamp),
    frame: part.header.frame_id,
  });
  const pose = (part, position, rotation) => ({
    child_frame: part.child_frame_id,
    x: position.x,
    y: position.y,
    yaw: yawOf(rotation),
  });
  if (plain === TYPES.scan) {
    const scan = about("scan", message);
    for (const name of SCAN_NUMBERS) scan[name] = textOf(message[name]);
    return [{ ...scan, ranges: Array.from(message.ranges, textOf) }];
  }
  if (plain === TYPES.odometry) {
    const { position, orientation } = message.pose.pose;
    return [{ ...about("odometry", message), ...pose(message, position, orientation) }];
  }
  if (plain !== TYPES.transform && plain !== "tf/tfMessage") return [];
  return message.transforms.map((part) => {
    const { translation, rotation } = part.transform;
    return { ...about("transform", part), ...pose(part, translation, rotation) };
  });
}

// A type's definition and those of all its parts, the type's own first.
function definitionsOf(library, type) {
  const found = new Map();
  const take = (name) => {
    if (found.has(name)) return;
    found.set(name, library[name]);
    for (const field of library[name].definitions) if (field.isComplex) take(field.type);
  };
  take(type);
  return [...found.values()];
}

// How the messages of a line's kind are written: "ros1" or "cdr".
export function writerOf(encoding, kind) {
  const type = TYPES[kind];
  const library = encoding === "ros1" ? common.ros1 : common.ros2jazzy;
  const [{ definitions: fields }, ...parts] = definitionsOf(library, type);
  const all = [{ definitions: fields }, ...parts];
  const writer = encoding === "ros1" ? new Ros1Writer(all) : new Ros2Writer(all);
  let text = stringify(all);
  if (encoding === "cdr") {
    // What ROS 2 itself writes for a time.
    text = text.replace(/^time /gm, "builtin_interfaces/Time ") +
      `\n${"=".repeat(80)}\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n`;
  }
  const typeInFile = encoding === "ros1" ? type : type.replace("/", "/msg/");
  return { type: typeInFile, definition: text, write: (message) => writer.writeMessage(message) };
}

// The lines on standard input.
export async function* readLines() {
  for await (const text of createInterface({ input: process.stdin })) {
    if (text !== "") yield JSON.parse(text);
  }
}

export function print(line) {
  process.stdout.write(JSON.stringify(line) + "\n");
}
