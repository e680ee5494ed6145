# SPDX-License-Identifier: Apache-2.0
"""What a campaign would take on a cluster: `python3 tools/schedule.py STORE --cores 64 --seeds 20000 --nodes 1,10,100,1000`.

The runs of every cell are drawn again, with replacement, from the wall times that STORE holds of it, `--seeds` of each. They are dealt into
shards as `fairway submit` deals them; a shard takes as long as its longest core, to which its runs go one by one, and `--start` seconds more.
The scheduler starts `--wave` shards at once at most, and `--gap` seconds later the next. Prints for each number of nodes the shards, the wall time,
and the share of all cores' time that went into runs.
"""

import argparse
import heapq
import json
import random
import sqlite3


def times_by_cell(store):
    cells = {}
    for labels, wall in sqlite3.connect(store).execute("select labels, wall_s from runs where failure = ''"):
        cells.setdefault(labels, []).append(wall)
    return list(cells.values())


def shards_of(cells, count):
    """Run times of each shard: as many runs of every cell as any other shard, what is left over to whoever has least."""
    shards = [[] for _ in range(count)]
    lightest = [(0.0, shard) for shard in range(count)]
    for times in sorted(cells, key=lambda times: -sum(times) / len(times)):
        even = len(times) // count * count
        for run, time in enumerate(times[:even]):
            shards[run % count].append(time)
        taken = []
        for time in times[even:]:
            load, shard = heapq.heappop(lightest)
            shards[shard].append(time)
            taken.append((load + sum(times) / len(times), shard))
        for entry in taken:
            heapq.heappush(lightest, entry)
    return shards


def longest_core(times, cores):
    free = [0.0] * cores
    for time in times:
        heapq.heappush(free, heapq.heappop(free) + time)
    return max(free)


def wall_time(shards, nodes, options):
    """Of shards that are started in waves, each on the node that is free first."""
    free = [0.0] * nodes
    now, started = 0.0, 0
    for times in shards:
        if started == options.wave:
            now, started = now + options.gap, 0
        begin = max(now, heapq.heappop(free))
        if begin > now:  # the scheduler waits for a node
            now, started = begin + options.gap, 0
            begin = now
        started += 1
        heapq.heappush(free, begin + options.start + longest_core(times, options.cores))
    return max(free)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("store")
    parser.add_argument("--nodes", default="1,10,100,1000")
    parser.add_argument("--cores", type=int, default=1, help="of each node")
    parser.add_argument("--seeds", type=int, default=1000, help="of each cell")
    parser.add_argument("--start", type=float, default=1.0, help="seconds that a shard takes besides its runs")
    parser.add_argument("--wave", type=int, default=100, help="shards that the scheduler starts at once")
    parser.add_argument("--gap", type=float, default=0.9, help="seconds between two waves")
    parser.add_argument("--most", type=int, default=1001, help="shards in an array")
    options = parser.parse_args()
    draw = random.Random(1)
    cells = [draw.choices(times, k=options.seeds) for times in times_by_cell(options.store)]
    total = sum(map(sum, cells))
    for nodes in map(int, options.nodes.split(",")):
        count = max(1, min(int(total / options.cores / 30), max(4 * nodes, 1), options.most))
        count -= count % nodes if count > nodes else 0
        wall = wall_time(shards_of(cells, count), nodes, options)
        print(json.dumps({"nodes": nodes, "cores": nodes * options.cores, "runs": sum(map(len, cells)), "core_hours": round(total / 3600, 2), "shards": count,
                          "wall_s": round(wall, 1), "busy": round(total / wall / nodes / options.cores, 3)}))


if __name__ == "__main__":
    main()
