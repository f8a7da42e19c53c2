// More values than the array has places.
#declare Sizes = array[2] { 1, 2, 3 }
