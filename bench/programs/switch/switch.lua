function bench()
  local done = 0
  local jobs = {}
  for j = 1, 100 do
    jobs[j] = coroutine.create(function()
      local i = 0
      while i < 1000 do
        i = i + 1
        coroutine.yield()
      end
      done = done + i
    end)
  end
  local live = true
  while live do
    live = false
    for j = 1, 100 do
      local job = jobs[j]
      if coroutine.status(job) ~= "dead" then
        coroutine.resume(job)
        live = true
      end
    end
  end
  return done
end

function base()
  local done = 0
  for j = 1, 100 do
    local i = 0
    while i < 1000 do i = i + 1 end
    done = done + i
  end
  return done
end
