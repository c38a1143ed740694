"""The atoms of the language of types, a module each, found by its name: `TYPE` makes the type.

`TYPE` is called with the texts between the parentheses behind the name, if there are any, or is itself a text
of the language, for which the name then stands. A pack keeps its own in the folder `types` of its problems.
"""
