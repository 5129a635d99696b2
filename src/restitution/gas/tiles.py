"""Tiles: the discs of a rectangle of cells and of a halo around it, out of the box and back.

A tile is small enough for its discs to stay in the processor's cache while they are carried
through a window of time. What it computes for its own discs is kept; what it computes for those
of the halo only serves to check it (see ``docs/gas.md``). As in ``kernel``, these are plain
functions over flat sequences, to be compiled for large runs.
"""

from __future__ import annotations

from restitution.gas.kernel import (
    BLOCK_FULL,
    COLUMN,
    COUNT,
    LINE,
    OUTSIDE,
    PARTNER,
    SEEN,
    VX,
    VY,
    WALL,
    T,
    X,
    Y,
)

# How filling ends (a code that the kernel knows by another name has its number).
FILLED, NO_ROOM = 0, -2

# What is kept of a disc of the halo, to be compared with its owner's: slot, x, y, vx, vy, t, count.
COPIED = 7

# A tile in numbers, in ``plan``: its first column and line (which may lie beyond the box, through
# a periodic wall), its columns and lines, what it owns of them, and how much farther the discs lie
# that may touch its own within the window.
(
    FIRST_COLUMN,
    FIRST_LINE,
    COLUMNS,
    LINES,
    OWN_FIRST_COLUMN,
    OWN_FIRST_LINE,
    OWN_COLUMNS,
    OWN_LINES,
    NEAR,
) = range(9)


def index(small, discs, columns, cells, starts, members):
    """Sort the discs by their cells: those of cell c are members[starts[c]:starts[c + 1]]."""
    for cell in range(cells + 1):
        starts[cell] = 0
    for slot in range(discs):
        starts[small[8 * slot + LINE] * columns + small[8 * slot + COLUMN]] += 1
    total = 0
    for cell in range(cells):
        total += starts[cell]
        starts[cell] = total
    starts[cells] = total
    for slot in range(discs - 1, -1, -1):
        cell = small[8 * slot + LINE] * columns + small[8 * slot + COLUMN]
        starts[cell] -= 1
        members[starts[cell]] = slot


def gather(
    plan,
    row_all,
    small_all,
    tally_all,
    names_all,
    starts,
    members,
    columns_all,
    lines_all,
    hard_x,
    hard_y,
    edges_all_x,
    edges_all_y,
    length_x,
    length_y,
    local_of,
    slot_of,
    row,
    small,
    tally,
    names,
    blocks,
    width,
    edges_x,
    edges_y,
    west,
    east,
    south,
    north,
    seams_x,
    seams_y,
    disc_counts,
):
    """Fill a tile's own arrays from those of the box; ``disc_counts`` gets three numbers of discs.

    These are its own, these and the near ones of the halo, and all. Its own come first, then
    the near ones. Returns FILLED, NO_ROOM for so many discs, or
    the kernel's BLOCK_FULL.
    """
    first_column, first_line = plan[FIRST_COLUMN], plan[FIRST_LINE]
    columns, lines = plan[COLUMNS], plan[LINES]
    own_column, own_line = plan[OWN_FIRST_COLUMN], plan[OWN_FIRST_LINE]
    own_columns, own_lines = plan[OWN_COLUMNS], plan[OWN_LINES]
    near = plan[NEAR]

    # The grid of cells: edges, and what lies beyond each column and line.
    for column in range(columns + 1):
        there = first_column + column
        turn = there // columns_all
        edges_x[column] = edges_all_x[there - turn * columns_all] + turn * length_x
        seams_x[column] = (not hard_x) and there % columns_all == 0
    for column in range(columns):
        west[column] = column - 1 if column > 0 else OUTSIDE
        east[column] = column + 1 if column < columns - 1 else OUTSIDE
    if columns == columns_all and not hard_x:
        west[0] = columns - 1
        east[columns - 1] = 0
    if hard_x and first_column == 0:
        west[0] = WALL
    if hard_x and first_column + columns == columns_all:
        east[columns - 1] = WALL
    for line in range(lines + 1):
        there = first_line + line
        turn = there // lines_all
        edges_y[line] = edges_all_y[there - turn * lines_all] + turn * length_y
        seams_y[line] = (not hard_y) and there % lines_all == 0
    for line in range(lines):
        south[line] = line - 1 if line > 0 else OUTSIDE
        north[line] = line + 1 if line < lines - 1 else OUTSIDE
    if lines == lines_all and not hard_y:
        south[0] = lines - 1
        north[lines - 1] = 0
    if hard_y and first_line == 0:
        south[0] = WALL
    if hard_y and first_line + lines == lines_all:
        north[lines - 1] = WALL

    for cell in range(columns * lines):
        blocks[cell * width] = 0

    # The discs: first the tile's own, then those near it, then the rest.
    i = 0
    for ring in range(3):
        for line in range(lines):
            below = own_line - line
            above = line - (own_line + own_lines - 1)
            off_line = max(below, above, 0)
            there_line = (first_line + line) % lines_all
            turn_y = (first_line + line) // lines_all
            for column in range(columns):
                before = own_column - column
                behind = column - (own_column + own_columns - 1)
                off = max(off_line, before, behind)
                if (0 if off == 0 else 1 if off <= near else 2) != ring:
                    continue
                turn_x = (first_column + column) // columns_all
                cell = there_line * columns_all + (first_column + column) % columns_all
                for entry in range(starts[cell], starts[cell + 1]):
                    if 8 * i == len(row):
                        return NO_ROOM
                    slot = members[entry]
                    local_of[slot] = i
                    slot_of[i] = slot
                    names[i] = names_all[slot]
                    for part in range(8):
                        row[8 * i + part] = row_all[8 * slot + part]
                        small[8 * i + part] = small_all[8 * slot + part]
                    for part in range(4):
                        tally[4 * i + part] = tally_all[4 * slot + part]
                    row[8 * i + X] += turn_x * length_x
                    row[8 * i + Y] += turn_y * length_y
                    small[8 * i + COLUMN] = column
                    small[8 * i + LINE] = line
                    for over in range(3):
                        at_line = line if over == 0 else south[line] if over == 1 else north[line]
                        if at_line < 0:
                            continue
                        first = at_line * columns
                        for along in range(3):
                            at_column = (
                                column
                                if along == 0
                                else west[column]
                                if along == 1
                                else east[column]
                            )
                            if at_column < 0:
                                continue
                            block = (first + at_column) * width
                            held = blocks[block] + 1
                            if held == width:
                                return BLOCK_FULL
                            blocks[block] = held
                            blocks[block + held] = i
                    i += 1
        disc_counts[ring] = i

    # Partners by their numbers within the tile. One outside is not known: to be predicted anew.
    for i in range(disc_counts[2]):
        partner = small[8 * i + PARTNER]
        if partner >= 0:
            j = local_of[partner]
            if j < disc_counts[2] and slot_of[j] == partner:
                small[8 * i + PARTNER] = j
            else:
                small[8 * i + PARTNER] = i
                small[8 * i + SEEN] = small[8 * i + COUNT] - 1
    return FILLED


def scatter(
    plan,
    disc_counts,
    slot_of,
    row,
    small,
    tally,
    columns_all,
    lines_all,
    length_x,
    length_y,
    row_all,
    small_all,
    tally_all,
    copies,
):
    """Write a tile's own discs into the arrays of the box, and the near ones of its halo apart."""
    first_column, first_line = plan[FIRST_COLUMN], plan[FIRST_LINE]
    owned = disc_counts[0]
    for i in range(disc_counts[1]):
        slot = slot_of[i]
        column = first_column + small[8 * i + COLUMN]
        line = first_line + small[8 * i + LINE]
        x = row[8 * i + X] - (column // columns_all) * length_x
        y = row[8 * i + Y] - (line // lines_all) * length_y
        if i < owned:
            for part in range(8):
                row_all[8 * slot + part] = row[8 * i + part]
                small_all[8 * slot + part] = small[8 * i + part]
            for part in range(4):
                tally_all[4 * slot + part] = tally[4 * i + part]
            row_all[8 * slot + X] = x
            row_all[8 * slot + Y] = y
            small_all[8 * slot + COLUMN] = column % columns_all
            small_all[8 * slot + LINE] = line % lines_all
            partner = small[8 * i + PARTNER]
            if partner >= 0:
                small_all[8 * slot + PARTNER] = slot_of[partner]
        else:
            at = COPIED * (i - owned)
            copies[at] = slot
            copies[at + 1] = x
            copies[at + 2] = y
            copies[at + 3] = row[8 * i + VX]
            copies[at + 4] = row[8 * i + VY]
            copies[at + 5] = row[8 * i + T]
            copies[at + 6] = small[8 * i + COUNT]


def differing(copies, number, row_all, small_all):
    """How many discs of a halo did not move as their owners say, to the last bit."""
    different = 0
    for at in range(0, COPIED * number, COPIED):
        slot = int(copies[at])
        if not (
            copies[at + 1] == row_all[8 * slot + X]
            and copies[at + 2] == row_all[8 * slot + Y]
            and copies[at + 3] == row_all[8 * slot + VX]
            and copies[at + 4] == row_all[8 * slot + VY]
            and copies[at + 5] == row_all[8 * slot + T]
            and copies[at + 6] == small_all[8 * slot + COUNT]
        ):
            different += 1
    return different
