local function unless(condition, action)
  if condition() then return nil else return action() end
end

function bench()
  local made = 0
  for i = 0, 999 do
    unless(function() return i % 4 == 0 end, function() made = made + i end)
  end
  return made
end
