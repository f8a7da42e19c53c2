// The square root of a negative number.
#declare Root = sqrt(-4);
