// What a web page does with roslib: argv are its folder and the port.
const { Action, Ros, Topic, Service } = await import(process.argv[2] + '/node_modules/roslib/dist/RosLib.js');
const say = (...words) => console.log(...words);
const ros = new Ros({ url: 'ws://127.0.0.1:' + process.argv[3] });
ros.on('error', (error) => say('error', String(error)));
await new Promise((done) => ros.on('connection', done));
const { topics, types } = await new Promise((done, failed) => ros.getTopics(done, failed));
say('topic', types[topics.indexOf('/chatter')]);
say('services', (await new Promise((done, failed) => ros.getServices(done, failed))).includes('/flip'));
for (const compression of ['none', 'png']) {
  const chatter = new Topic({ ros, name: '/chatter', messageType: 'std_msgs/String', compression, queue_length: 1, throttle_rate: 10 });
  const heard = await new Promise((done) => chatter.subscribe(done));
  say(compression, heard.data);
  chatter.unsubscribe();
}
const flip = new Service({ ros, name: '/flip', serviceType: 'std_srvs/SetBool' });
say('flip', JSON.stringify(await new Promise((done, failed) => flip.callService({ data: true }, done, failed))));
await new Promise((done, failed) => flip.callService({ date: true }, done, failed)).catch((error) => say(String(error)));
const offered = new Service({ ros, name: '/page', serviceType: 'std_srvs/SetBool' });
offered.advertise((request, response) => {
  response.success = request.data;
  response.message = 'a page';
  return true;
});
const count = new Action({ ros, name: '/count', actionType: 'test_msgs/Fibonacci' });
let steps = 0;
// A goal that waits is cancelled when it has told how far it is.
const pursue = (order) => new Promise((done) => {
  const id = count.sendGoal({ order }, (result) => done(JSON.stringify(result)), () => {
    steps++;
    if (order >= 100) count.cancelGoal(id);
  }, done);
});
say('goal', await pursue(1), steps);
say('goal', await pursue(100), steps);
say('goal', await pursue(-1), steps);
const ours = new Action({ ros, name: '/page_count', actionType: 'test_msgs/Fibonacci' });
ours.advertise((goal, id) => {
  ours.sendFeedback(id, { sequence: [0] });
  if (goal.order < 0) ours.setFailed(id);
  else if (goal.order < 100) ours.setSucceeded(id, { sequence: [0, goal.order] });
}, (id) => ours.setCanceled(id, { sequence: [7] }));
const said = new Topic({ ros, name: '/said', messageType: 'std_msgs/String' });
said.advertise();
said.publish({ data: 'by a page' });
const shapes = new Topic({ ros, name: '/shapes', messageType: 'test_msgs/UnboundedSequences', compression: 'cbor' });
const shape = await new Promise((done) => shapes.subscribe(done));
for (const [name, value] of Object.entries(shape))
  if (name.endsWith('_default')) say('cbor', name.split('_')[0], value.constructor.name, String(value));
say('cbor', JSON.stringify(shape.basic_types_values));
const bare = new Topic({ ros, name: '/chatter', messageType: 'std_msgs/String', compression: 'cbor-raw' });
const { bytes, secs, nsecs } = await new Promise((done) => bare.subscribe(done));
say('raw', Buffer.from(bytes).toString('hex'), Math.abs(secs + nsecs / 1e9 - Date.now() / 1000) < 60);
say('ready');
process.stdin.on('data', () => process.exit(0));
