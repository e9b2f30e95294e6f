function bench()
  local done = 0
  local jobs = {}
  for i = 1, 10000 do
    jobs[i] = coroutine.create(function() done = done + 1 end)
  end
  for i = 1, 10000 do coroutine.resume(jobs[i]) end
  return done
end
