// A vector of six components.
#declare V = <1, 2, 3, 4, 5, 6>;
