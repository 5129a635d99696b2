"""``python -m restitution``: the command line."""

from restitution.cli import main

if __name__ == "__main__":
    main()
