"""One line and what it cites: values put in, signs, equations solved."""
