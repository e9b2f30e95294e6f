local keys = {}
for i = 0, 99 do keys[#keys + 1] = "key" .. i end

function bench()
  local counts = {}
  for _, key in ipairs(keys) do counts[key] = 0 end
  for i = 1, 1000 do
    for _, key in ipairs(keys) do counts[key] = counts[key] + 1 end
  end
  return counts["key42"]
end
