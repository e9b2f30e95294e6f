// Looks at a server by Foxglove's own client: node look.cjs ADDRESS SUBPROTOCOL, with NODE_PATH. Each line tells of one
// thing that it has heard; it leaves when the variable ball.x is 5, and it has seen a picture.
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

const [address, subprotocol] = process.argv.slice(2);
const client = new FoxgloveClient({ ws: new WebSocket(address, [subprotocol]) });
const topics = new Map();
const missing = new Set(["asked", "ball", "picture", "jobs", "call", "failure"]);
const text = (bytes) => new TextDecoder().decode(bytes);
/** The last thing that was missing may be of any kind. */
const seen = (what) => {
  if (missing.delete(what) && missing.size === 0) client.close();
};

client.on("error", (error) => console.log("error", String(error)));
client.on("close", () => {
  console.log("closed");
  process.exit(0);
});
client.on("serverInfo", (info) => {
  console.log("server", info.capabilities.join(" "));
});
client.on("status", (status) => console.log("status", status.level, status.message));
client.on("time", (time) => topics.set("time", time.timestamp));
client.on("parameterValues", (values) => {
  for (const { name, value } of values.parameters) console.log("parameter", values.id, name, JSON.stringify(value));
  seen(values.id);
});
client.on("advertise", (channels) => {
  for (const channel of channels) {
    console.log("channel", channel.topic, channel.encoding, channel.schemaName, JSON.parse(channel.schema).type);
    topics.set(client.subscribe(channel.id), channel.topic);
    if (channel.topic === "/ball/x") {
      client.getParameters(["ball.x"], "asked");
      client.setParameters([{ name: "ball.x", value: 3 }], "set");
      const own = client.advertise({ topic: "/seen", encoding: "json", schemaName: "urbi.List" });
      client.sendMessage(own, new TextEncoder().encode(JSON.stringify({ value: ["hello"] })));
    }
  }
});
client.on("advertiseServices", ([{ id, name, type, request, response }]) => {
  console.log("service", name, type, request.encoding, response.schemaName);
  const call = (callId, content) => {
    const bytes = new TextEncoder().encode(JSON.stringify(content));
    client.sendServiceCallRequest({ serviceId: id, callId, encoding: "json", data: new DataView(bytes.buffer) });
  };
  call(1, { function: "ball.plus", arguments: [4] });
  call(2, { function: "nothing" });
});
client.on("serviceCallResponse", ({ callId, encoding, data }) => {
  console.log("response", callId, encoding, text(data));
  seen("call");
});
client.on("serviceCallFailure", ({ callId, message }) => {
  console.log("failure", callId, message);
  seen("failure");
});
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const message = JSON.parse(text(data));
  const topic = topics.get(subscriptionId);
  const age = Math.abs(Date.now() - Number(timestamp / 1000000n)) < 60000 ? "now" : "once";
  if (message.jobs) {
    if (missing.has("jobs")) console.log("jobs", message.jobs.some((job) => job.tags.includes("counting")));
    seen("jobs");
    return;
  }
  if (message.data !== undefined) message.data = Buffer.from(message.data, "base64").subarray(0, 3).toString("hex");
  console.log("message", topic, age, message.value ?? message.message ?? message.data);
  if (topic === "/ball/x" && message.value === 5) seen("ball");
  if (topic === "/ball/picture") seen("picture");
});
