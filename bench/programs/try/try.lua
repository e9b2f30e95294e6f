function bench()
  local caught = 0
  for i = 0, 9999 do
    local ok, e = pcall(function() error("ball") end)
    if not ok then caught = caught + 1 end
  end
  return caught
end
