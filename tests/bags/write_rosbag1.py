# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Writes a ROS 1 bag by ROS's own library: write_rosbag1.py none|bz2|lz4 BAG <LINES

The lines are those of made_recording.py. Chunks are small, so that the bag has several.
"""
import json
import math
import sys

import rosbag
import rospy
from geometry_msgs.msg import Quaternion, TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

CHUNK_BYTES = 20000


def time_of(text):
    seconds, nanoseconds = divmod(int(text), 1_000_000_000)
    return rospy.Time(seconds, nanoseconds)


def quaternion_of(yaw):
    return Quaternion(0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2))


def scan_of(line):
    scan = LaserScan()
    for name in ("angle_min", "angle_max", "angle_increment", "time_increment", "scan_time",
                 "range_min", "range_max"):
        setattr(scan, name, line[name])
    scan.ranges = [float(text) for text in line["ranges"]]
    return scan


def odometry_of(line):
    odometry = Odometry()
    odometry.child_frame_id = line["child_frame"]
    odometry.pose.pose.position.x = line["x"]
    odometry.pose.pose.position.y = line["y"]
    odometry.pose.pose.orientation = quaternion_of(line["yaw"])
    return odometry


def transform_of(line):
    transform = TransformStamped()
    transform.child_frame_id = line["child_frame"]
    transform.transform.translation.x = line["x"]
    transform.transform.translation.y = line["y"]
    transform.transform.rotation = quaternion_of(line["yaw"])
    return transform


def message_of(line):
    make = {"scan": scan_of, "odometry": odometry_of, "transform": transform_of}[line["kind"]]
    message = make(line)
    message.header.stamp = time_of(line["stamp_ns"])
    message.header.frame_id = line["frame"]
    return TFMessage([message]) if line["kind"] == "transform" else message


def main():
    compression, path = sys.argv[1:]
    with rosbag.Bag(path, "w", compression=compression, chunk_threshold=CHUNK_BYTES) as bag:
        for text in sys.stdin:
            line = json.loads(text)
            bag.write(line["topic"], message_of(line), time_of(line["log_time_ns"]))


main()
