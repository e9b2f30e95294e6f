/// Stands where 2.7 switched warnings off; there is nothing to switch.
