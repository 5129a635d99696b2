"""The loop of the many: next event, impact, what comes next; over one tile and one window of time.

This one function is the whole of the fast engine. It is plain Python over flat sequences, so that
small runs use it as it stands (with lists) and large ones as Numba compiles it (with arrays); and
it is one function, with the prediction at a single place, because that is what a compiler makes
the best of. ``docs/gas.md`` draws what is said here.

The state of disc i, as the flat rows

    row[8 i …]     x, y, vx, vy, t, radius, time of the next event, mass        64 bytes, floats
    small[8 i …]   column, line, partner, seen, count, quick, turns in x, in y  32 bytes, integers
    tally[4 i …]   virial, impulse on walls across x, across y, time of the last impact

says where it was at its last change of velocity, t, and what will happen to it next: ``partner``
is another disc, or one of the codes below for the edges of its cell. ``count`` is the number of its
velocity changes; ``seen`` is the partner's count when the event was predicted, so that an event
with a partner who has been struck since is recognised, and predicted anew when its time comes.

The places (x, y) are whole multiples of a length so small (the box's ``resolution``) that they
lose nothing by it, and sums and differences of them are exact. Therefore the same discs seen from
another tile, or through a periodic wall, move alike to the last bit.
"""

from __future__ import annotations

import math

# Places in a disc's rows.
X, Y, VX, VY, T, RADIUS, NEXT, MASS = range(8)
COLUMN, LINE, PARTNER, SEEN, COUNT, QUICK, TURNS_X, TURNS_Y = range(8)
VIRIAL, WALL_X, WALL_Y, LAST_HIT = range(4)

# Partners that are no disc: an edge of the cell, nothing (the disc left the tile), not yet asked.
EDGE_X, EDGE_Y, NOTHING, UNASKED = -1, -2, -3, -4
# What lies beyond the edge of a column or a line of cells, where it is no other cell.
WALL, OUTSIDE = -1, -2

# How a call ends.
DONE, BLOCK_FULL, AGENDA_FULL, LOG_FULL, COLLAPSE = range(5)

# Numbers of a whole run, in ``constants``.
(
    LENGTH_X,
    LENGTH_Y,
    HALF_X,
    HALF_Y,
    ROUND_PLACE,
    ROUND_TIME,
    SAME_TIME,
    GRAZING,
    E_DISCS,
    E_WALLS,
    CONTACT_TIME,
    FLIGHT,
    AT_ONCE,
    CONSTANTS,
) = range(14)

# So many times the resolution a disc may go before its place is taken anew: what it goes is rounded
# to whole multiples of the resolution only up to twice as far.
FARTHEST = 2.0**50

# Columns of the log of impacts, one row an impact.
LOGGED = 12

# In ``totals``: twice the impacts of discs, impacts with walls, twice those made elastic,
# predictions, events taken from the calendar, crossings; the fastest speed squared is a float.
TWICE_PAIRS, WALLS, TWICE_ELASTIC, SCANS, POPS, CROSSINGS, LOGS, CULPRIT = range(8)


def advance(
    row,
    small,
    tally,
    names,
    discs,
    owned,
    blocks,
    width,
    calendar,
    days,
    page,
    spill,
    agenda_times,
    agenda_discs,
    edges_x,
    edges_y,
    west,
    east,
    south,
    north,
    seams_x,
    seams_y,
    columns,
    wraps,
    constants,
    start,
    end,
    logging,
    log,
    totals,
    fastest,
):
    """Carry ``discs`` discs, of which the first ``owned`` are the tile's own, to time ``end``.

    ``blocks`` has a row of ``width`` ids for each cell (their number first): all discs in its
    3 × 3 block. ``calendar`` has ``days`` rows of ``page`` ids (their number first), each for an
    equal part of the time from ``start`` to ``end``; an entry counts if its disc's next event still
    falls on that day, so nothing is ever struck out. Returns one of the codes above.
    """
    length_x, length_y = constants[LENGTH_X], constants[LENGTH_Y]
    half_x, half_y = constants[HALF_X], constants[HALF_Y]
    round_place, round_time = constants[ROUND_PLACE], constants[ROUND_TIME]
    same_time, grazing = constants[SAME_TIME], constants[GRAZING]
    e_discs, e_walls = constants[E_DISCS], constants[E_WALLS]
    contact_time = constants[CONTACT_TIME]
    flight = constants[FLIGHT]
    at_once = constants[AT_ONCE]
    infinity = math.inf
    per_time = days / (end - start)
    last_day = days - 1

    twice_pairs = walls = twice_elastic = scans = pops = crossings = logs = 0
    v2_max = fastest[0]

    # The calendar: what is known already. Today is the first day; its agenda is made below.
    for entry in range(0, days * page, page):
        calendar[entry] = 0
    spilled = 0
    today = -1
    planned = 0
    asked = 0  # discs before this one have their first prediction
    todo = -1  # the second disc of an impact, to be predicted after the first
    now = start
    for i in range(discs):
        time = row[8 * i + NEXT]
        if time < end and small[8 * i + PARTNER] != UNASKED:
            day = min(int((time - start) * per_time), last_day)
            held = calendar[day * page]
            if held < page - 1:
                calendar[day * page] = held + 1
                calendar[day * page + held + 1] = i
            else:
                spill[spilled] = i
                spilled += 1

    while True:
        # --- what is to be predicted: after an event, its discs; at the very start, all ----------
        if todo >= 0:
            i = todo
            todo = -1
        elif asked < discs:
            i = asked
            asked += 1
            if small[8 * i + PARTNER] != UNASKED:
                continue
        else:
            # --- the next event ------------------------------------------------------------------
            best = infinity
            chosen = -1
            for entry in range(planned):
                time = agenda_times[entry]
                if time < best:
                    best = time
                    chosen = entry
                elif time == best and (names[agenda_discs[entry]] < names[agenda_discs[chosen]]):
                    chosen = entry
            if chosen < 0:
                # The day is over. What is on the next day's page, and spilt over, is its agenda.
                today += 1
                if today == days:
                    break
                for entry in range(today * page + 1, today * page + 1 + calendar[today * page]):
                    i = calendar[entry]
                    time = row[8 * i + NEXT]
                    if time < end and min(int((time - start) * per_time), last_day) == today:
                        agenda_times[planned] = time
                        agenda_discs[planned] = i
                        planned += 1
                if spilled > 0:
                    kept = 0
                    for entry in range(spilled):
                        i = spill[entry]
                        time = row[8 * i + NEXT]
                        if time < end:
                            day = min(int((time - start) * per_time), last_day)
                            if day == today:
                                if planned == len(agenda_times):
                                    return AGENDA_FULL
                                agenda_times[planned] = time
                                agenda_discs[planned] = i
                                planned += 1
                            elif day > today:
                                spill[kept] = i
                                kept += 1
                    spilled = kept
                continue
            i = agenda_discs[chosen]
            planned -= 1
            agenda_times[chosen] = agenda_times[planned]
            agenda_discs[chosen] = agenda_discs[planned]
            a = 8 * i
            if row[a + NEXT] != best:  # it has another event by now
                continue
            pops += 1
            now = best
            partner = small[a + PARTNER]
            if partner >= 0:
                j = partner
                b = 8 * j
                if small[b + COUNT] == small[a + SEEN]:
                    # --- an impact of two discs --------------------------------------------------
                    since_i = now - row[a + T]
                    since_j = now - row[b + T]
                    x1 = row[a + X] + ((row[a + VX] * since_i + round_place) - round_place)
                    y1 = row[a + Y] + ((row[a + VY] * since_i + round_place) - round_place)
                    x2 = row[b + X] + ((row[b + VX] * since_j + round_place) - round_place)
                    y2 = row[b + Y] + ((row[b + VY] * since_j + round_place) - round_place)
                    dx = x2 - x1
                    dy = y2 - y1
                    if dx > half_x:
                        dx -= length_x
                    elif dx < -half_x:
                        dx += length_x
                    if dy > half_y:
                        dy -= length_y
                    elif dy < -half_y:
                        dy += length_y
                    dvx = row[b + VX] - row[a + VX]
                    dvy = row[b + VY] - row[a + VY]
                    e = e_discs
                    if contact_time > 0.0:
                        last = max(tally[4 * i + LAST_HIT], tally[4 * j + LAST_HIT])
                        if now - last < contact_time and e < 1.0:
                            e = 1.0
                            twice_elastic += (i < owned) + (j < owned)
                        tally[4 * i + LAST_HIT] = now
                        tally[4 * j + LAST_HIT] = now
                    m1 = row[a + MASS]
                    m2 = row[b + MASS]
                    # the law: impulse (1 + e) (du . c) / ((w1 + w2) c . c) along c, as c = (dx, dy)
                    approach = -(dx * dvx + dy * dvy)
                    share = (1.0 + e) * approach / ((m1 + m2) * (dx * dx + dy * dy))
                    if logging and (i if names[i] < names[j] else j) < owned:
                        if (logs + 1) * LOGGED > len(log):
                            return LOG_FULL
                        entry = logs * LOGGED
                        log[entry] = now
                        log[entry + 1] = names[i]
                        log[entry + 2] = names[j]
                        log[entry + 3] = x1
                        log[entry + 4] = y1
                        log[entry + 5] = dx
                        log[entry + 6] = dy
                        log[entry + 7] = row[a + VX]
                        log[entry + 8] = row[a + VY]
                        log[entry + 9] = row[b + VX]
                        log[entry + 10] = row[b + VY]
                        log[entry + 11] = share
                        logs += 1
                    row[a + X] = x1
                    row[a + Y] = y1
                    row[b + X] = x2
                    row[b + Y] = y2
                    row[a + T] = now
                    row[b + T] = now
                    vx = row[a + VX] - dx * (share * m2)
                    vy = row[a + VY] - dy * (share * m2)
                    row[a + VX] = vx
                    row[a + VY] = vy
                    v2_max = max(v2_max, vx * vx + vy * vy)
                    vx = row[b + VX] + dx * (share * m1)
                    vy = row[b + VY] + dy * (share * m1)
                    row[b + VX] = vx
                    row[b + VY] = vy
                    v2_max = max(v2_max, vx * vx + vy * vy)
                    # half of impulse times distance goes to each
                    virial = 0.5 * (share * m1 * m2 * (dx * dx + dy * dy))
                    tally[4 * i + VIRIAL] += virial
                    tally[4 * j + VIRIAL] += virial
                    small[a + COUNT] += 1
                    small[b + COUNT] += 1
                    twice_pairs += (i < owned) + (j < owned)
                    if min(since_i, since_j) <= same_time:
                        small[a + QUICK] += 1
                        small[b + QUICK] += 1
                        if max(small[a + QUICK], small[b + QUICK]) > at_once:
                            totals[CULPRIT] = i if i < owned else j
                            fastest[1] = now
                            return COLLAPSE
                    else:
                        small[a + QUICK] = 0
                        small[b + QUICK] = 0
                    todo = j
            elif partner == NOTHING:
                continue
            else:
                # --- an edge of the cell: a wall, or another cell --------------------------------
                across_x = partner == EDGE_X
                column = small[a + COLUMN]
                line = small[a + LINE]
                if across_x:
                    onward = row[a + VX] > 0.0
                    beyond = east[column] if onward else west[column]
                else:
                    onward = row[a + VY] > 0.0
                    beyond = north[line] if onward else south[line]
                since_i = now - row[a + T]
                if beyond == WALL:
                    x1 = row[a + X] + ((row[a + VX] * since_i + round_place) - round_place)
                    y1 = row[a + Y] + ((row[a + VY] * since_i + round_place) - round_place)
                    normal = row[a + VX] if across_x else row[a + VY]
                    e = e_walls
                    if contact_time > 0.0:
                        if now - tally[4 * i + LAST_HIT] < contact_time and e < 1.0:
                            e = 1.0
                            twice_elastic += 2 * (i < owned)
                        tally[4 * i + LAST_HIT] = now
                    if logging and i < owned:
                        if (logs + 1) * LOGGED > len(log):
                            return LOG_FULL
                        entry = logs * LOGGED
                        log[entry] = now
                        log[entry + 1] = names[i]
                        log[entry + 2] = -1.0 if across_x else -2.0
                        log[entry + 3] = x1
                        log[entry + 4] = y1
                        log[entry + 5] = (1.0 if onward else -1.0) if across_x else 0.0
                        log[entry + 6] = 0.0 if across_x else (1.0 if onward else -1.0)
                        log[entry + 7] = row[a + VX]
                        log[entry + 8] = row[a + VY]
                        log[entry + 9] = 0.0
                        log[entry + 10] = 0.0
                        log[entry + 11] = (1.0 + e) * abs(normal)
                        logs += 1
                    row[a + X] = x1
                    row[a + Y] = y1
                    row[a + T] = now
                    impulse = (1.0 + e) * abs(normal) * row[a + MASS]
                    if across_x:
                        row[a + VX] = -e * normal
                        tally[4 * i + WALL_X] += impulse
                    else:
                        row[a + VY] = -e * normal
                        tally[4 * i + WALL_Y] += impulse
                    small[a + COUNT] += 1
                    walls += i < owned
                    if since_i <= same_time:
                        small[a + QUICK] += 1
                        if small[a + QUICK] > at_once:
                            totals[CULPRIT] = i
                            fastest[1] = now
                            return COLLAPSE
                    else:
                        small[a + QUICK] = 0
                else:
                    crossings += 1
                    if across_x:
                        seam = seams_x[column + 1 if onward else column] != 0
                    else:
                        seam = seams_y[line + 1 if onward else line] != 0
                    long = max(abs(row[a + VX]), abs(row[a + VY])) * since_i > flight
                    if seam or long:  # the place counts from here
                        row[a + X] += (row[a + VX] * since_i + round_place) - round_place
                        row[a + Y] += (row[a + VY] * since_i + round_place) - round_place
                        row[a + T] = now
                    if seam:  # through a periodic wall: into the box
                        step = 1 if onward else -1
                        if across_x:
                            small[a + TURNS_X] += step
                            if half_x < infinity:
                                row[a + X] -= step * length_x
                        else:
                            small[a + TURNS_Y] += step
                            if half_y < infinity:
                                row[a + Y] -= step * length_y
                    # Out of the three blocks behind, into the three ahead.
                    for ahead in range(2):
                        if across_x:
                            if ahead == 0:
                                strip = west[column] if onward else east[column]
                            elif beyond == OUTSIDE:
                                break
                            else:
                                strip = east[beyond] if onward else west[beyond]
                        elif ahead == 0:
                            strip = south[line] if onward else north[line]
                        elif beyond == OUTSIDE:
                            break
                        else:
                            strip = north[beyond] if onward else south[beyond]
                        if strip < 0:
                            continue
                        for side in range(3):
                            if across_x:
                                other = line
                                if side == 1:
                                    other = south[line]
                                elif side == 2:
                                    other = north[line]
                                cell = other * columns + strip
                            else:
                                other = column
                                if side == 1:
                                    other = west[column]
                                elif side == 2:
                                    other = east[column]
                                cell = strip * columns + other
                            if other < 0:
                                continue
                            block = cell * width
                            held = blocks[block]
                            if ahead == 0:
                                entry = block + 1
                                while blocks[entry] != i:
                                    entry += 1
                                blocks[entry] = blocks[block + held]
                                blocks[block] = held - 1
                            else:
                                if held == width - 1:
                                    return BLOCK_FULL
                                blocks[block] = held + 1
                                blocks[block + held + 1] = i
                    if beyond == OUTSIDE:
                        # It left the tile; what it met in these cells, it met.
                        for side in range(3):
                            for ahead in range(2):
                                if across_x:
                                    strip = column
                                    if ahead == 1:
                                        strip = east[column] if onward else west[column]
                                    other = line
                                    if side == 1:
                                        other = south[line]
                                    elif side == 2:
                                        other = north[line]
                                    cell = other * columns + strip
                                else:
                                    strip = line
                                    if ahead == 1:
                                        strip = north[line] if onward else south[line]
                                    other = column
                                    if side == 1:
                                        other = west[column]
                                    elif side == 2:
                                        other = east[column]
                                    cell = strip * columns + other
                                if strip < 0 or other < 0:
                                    continue
                                block = cell * width
                                held = blocks[block]
                                entry = block + 1
                                while blocks[entry] != i:
                                    entry += 1
                                blocks[entry] = blocks[block + held]
                                blocks[block] = held - 1
                        small[a + PARTNER] = NOTHING
                        row[a + NEXT] = infinity
                        small[a + COUNT] += 1
                        continue
                    if across_x:
                        small[a + COLUMN] = beyond
                    else:
                        small[a + LINE] = beyond

        # --- predict: the edges of the cell, then all discs in the block -------------------------
        scans += 1
        a = 8 * i
        x = row[a + X]
        y = row[a + Y]
        vx = row[a + VX]
        vy = row[a + VY]
        since = row[a + T]
        radius = row[a + RADIUS]
        column = small[a + COLUMN]
        line = small[a + LINE]
        time = infinity
        partner = NOTHING
        if vx != 0.0:
            if vx > 0.0:
                edge = edges_x[column + 1] - x
                if east[column] == WALL:
                    edge -= radius
            else:
                edge = edges_x[column] - x
                if west[column] == WALL:
                    edge += radius
            time = since + edge / vx
            partner = EDGE_X
        if vy != 0.0:
            if vy > 0.0:
                edge = edges_y[line + 1] - y
                if north[line] == WALL:
                    edge -= radius
            else:
                edge = edges_y[line] - y
                if south[line] == WALL:
                    edge += radius
            other_time = since + edge / vy
            if other_time < time:
                time = other_time
                partner = EDGE_Y
        gone = now - since
        gone_x = vx * gone
        gone_y = vy * gone
        block = (line * columns + column) * width
        soonest = infinity
        nearest = -1
        for entry in range(block + 1, block + 1 + blocks[block]):
            b = 8 * blocks[entry]
            gone = now - row[b + T]
            dvx = row[b + VX]
            dvy = row[b + VY]
            away_x = dvx * gone - gone_x
            away_y = dvy * gone - gone_y
            dx = row[b + X] - x
            dy = row[b + Y] - y
            if wraps is not None:
                far = dx + away_x
                turn = length_x if far < -half_x else 0.0
                dx += -length_x if far > half_x else turn
                far = dy + away_y
                turn = length_y if far < -half_y else 0.0
                dy += -length_y if far > half_y else turn
            dx += away_x
            dy += away_y
            dvx -= vx
            dvy -= vy
            reach = radius + row[b + RADIUS]
            reach *= reach
            approach = dx * dvx + dy * dvy
            across = dx * dvy - dy * dvx
            most = reach * (dvx * dvx + dvy * dvy)
            inside = most - across * across
            hits = (approach < 0.0) & (inside > grazing * most)
            gap = dx * dx + dy * dy - reach
            after = gap / (math.sqrt(inside if hits else 1.0) - (approach if hits else -1.0))
            after = after if hits else infinity
            if after == soonest and nearest >= 0 and names[b >> 3] < names[nearest >> 3]:
                nearest = b
            sooner = after < soonest
            soonest = after if sooner else soonest
            nearest = b if sooner else nearest
        soonest += now
        if nearest >= 0 and soonest <= time:
            time = soonest
            partner = nearest >> 3
            small[a + SEEN] = small[nearest + COUNT]
        small[a + PARTNER] = partner
        time = (max(time, now) + round_time) - round_time
        row[a + NEXT] = time
        if time < end:
            day = min(int((time - start) * per_time), last_day)
            if day <= today:
                if planned == len(agenda_times):
                    kept = 0
                    for entry in range(planned):
                        if row[8 * agenda_discs[entry] + NEXT] == agenda_times[entry]:
                            agenda_times[kept] = agenda_times[entry]
                            agenda_discs[kept] = agenda_discs[entry]
                            kept += 1
                    planned = kept
                    if planned == len(agenda_times):
                        return AGENDA_FULL
                agenda_times[planned] = time
                agenda_discs[planned] = i
                planned += 1
            else:
                held = calendar[day * page]
                if held < page - 1:
                    calendar[day * page] = held + 1
                    calendar[day * page + held + 1] = i
                else:
                    if spilled == len(spill):
                        return AGENDA_FULL
                    spill[spilled] = i
                    spilled += 1

    totals[TWICE_PAIRS] += twice_pairs
    totals[WALLS] += walls
    totals[TWICE_ELASTIC] += twice_elastic
    totals[SCANS] += scans
    totals[POPS] += pops
    totals[CROSSINGS] += crossings
    totals[LOGS] = logs
    fastest[0] = v2_max
    return DONE
