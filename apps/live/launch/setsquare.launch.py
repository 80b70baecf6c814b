# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Live mapping in a launch of ROS 2, in place of slam_toolbox:

ros2 launch setsquare.launch.py params_file:=setsquare.yaml output:=/tmp/map
"""
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("params_file", description="Parameters (docs/live.md)"),
        DeclareLaunchArgument("output", default_value="map", description="Folder for the map"),
        ExecuteProcess(
            cmd=["setsquare", "live", "--ros2", "--network", "--slam-toolbox-names",
                 "--params-file", LaunchConfiguration("params_file"),
                 "-o", LaunchConfiguration("output")],
            output="screen",
            sigterm_timeout="30"),
    ])
