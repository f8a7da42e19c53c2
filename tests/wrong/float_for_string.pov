// A number where a string is needed.
#debug 5
