// A vector in a function, which knows only numbers.
#declare F = function(a) { vlength(<a, 1, 2>) }
