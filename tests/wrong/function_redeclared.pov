// A function declared twice.
#declare F = function(x) { x * 2 }
#declare F = function(x) { x * 3 }
