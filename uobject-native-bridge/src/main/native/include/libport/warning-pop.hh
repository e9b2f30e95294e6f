/// Stands where 2.7 switched warnings on again; there is nothing to switch.
