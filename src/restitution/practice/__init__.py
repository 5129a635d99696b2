"""Practice: mistakes as altered laws, free working read and judged line by line, marks, questions.

`working` reads what a student typed, `letters` knows what its letters mean, `world` is the story in
doubles (the true one, a random one, the student's own), `principles` tells which law a line uses,
`judging` gives each line its verdict, `mistakes` names what went wrong, `scheme` has the mark
points of a part, `marking` awards them, `messages` puts it into words.
"""
