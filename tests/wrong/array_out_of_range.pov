// Element 3 of an array of three.
#declare Sizes = array[3] { 1, 2, 3 }
sphere { 0, Sizes[3] }
