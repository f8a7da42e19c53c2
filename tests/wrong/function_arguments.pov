// A function called with too few arguments.
#declare F = function(a, b) { a + b }
sphere { 0, F(1) }
