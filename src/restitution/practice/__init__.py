"""Practice: a student's working read, judged and marked, and questions to practise.

A working is a `script` (`reading`), its letters mean quantities (`letters`), its lines are tried in
the story in doubles (`worlds`), each has a verdict (`judging`, a `judgement`), and the points of a
scheme find the lines that earn them (`marking`). `questions` makes practice questions.
"""
