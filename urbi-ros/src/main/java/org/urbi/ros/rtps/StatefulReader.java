package org.urbi.ros.rtps;

import java.net.InetSocketAddress;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** The protocol of a reader: one {@link WriterProxy} for each writer that it is matched with. */
final class StatefulReader {
  private final Environment environment;
  private final int entity;
  private final EndpointQos qos;
  private final SampleSink sink;
  private final Map<Guid, WriterProxy> writers = new LinkedHashMap<>();

  StatefulReader(Environment environment, int entity, EndpointQos qos, SampleSink sink) {
    this.environment = environment;
    this.entity = entity;
    this.qos = qos;
    this.sink = sink;
  }

  int entity() {
    return entity;
  }

  void match(Guid writer, EndpointQos offered, InetSocketAddress address) {
    unmatch(writer);
    writers.put(writer, new WriterProxy(environment, entity, qos, writer, offered, address, sink));
  }

  void unmatch(Guid writer) {
    WriterProxy proxy = writers.remove(writer);
    if (proxy != null) proxy.close();
  }

  /** What it knows of that writer; null if it is not matched with it. */
  @Nullable WriterProxy of(Guid writer) {
    return writers.get(writer);
  }

  List<Guid> matched() {
    return List.copyOf(writers.keySet());
  }

  void forEach(Consumer<WriterProxy> action) {
    writers.values().forEach(action);
  }

  /** There is room for samples again. */
  void resume() {
    forEach(WriterProxy::resume);
  }

  void close() {
    forEach(WriterProxy::close);
    writers.clear();
  }
}
