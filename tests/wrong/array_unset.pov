// An element that was never given a value.
#declare Sizes = array[3]
#declare Sizes[0] = 1;
sphere { 0, Sizes[1] }
