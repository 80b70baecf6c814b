# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
#
# docker build -t setsquare . && docker run -v "$PWD:/data" setsquare map /data/log.clf -o /data/out
# Not built where this project is developed.
FROM debian:12 AS build
RUN apt-get update
COPY . /setsquare
RUN cd /setsquare && tools/make_packages

FROM debian:12-slim
COPY --from=build /setsquare/build/release/packages/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/setsquare_*.deb /tmp/python3-setsquare_*.deb \
  && rm -rf /tmp/*.deb /var/lib/apt/lists/*
ENTRYPOINT ["setsquare"]
