// The semicolon after a declared number is missing.
#declare Radius = 2
sphere { 0, Radius }
