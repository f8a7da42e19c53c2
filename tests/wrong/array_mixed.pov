// An array of numbers and strings.
#declare Things = array[2] { 1, "two" }
