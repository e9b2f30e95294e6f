package org.urbi.ros.rtps;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Which readers of this participant a writer sends to. */
final class Routes {
  private final Map<Guid, List<StatefulReader>> readers = new HashMap<>();

  void add(Guid writer, StatefulReader reader) {
    readers.merge(
        writer,
        List.of(reader),
        (before, one) -> Stream.concat(before.stream(), one.stream()).toList());
  }

  void remove(Guid writer, StatefulReader reader) {
    readers.computeIfPresent(
        writer,
        (guid, before) -> {
          List<StatefulReader> left = before.stream().filter(each -> each != reader).toList();
          return left.isEmpty() ? null : left;
        });
  }

  void remove(StatefulReader reader) {
    reader.matched().forEach(writer -> remove(writer, reader));
  }

  List<StatefulReader> of(Guid writer) {
    return readers.getOrDefault(writer, List.of());
  }

  /**
   * A participant vouches for its writers: for those whose liveliness it looks after itself, or for
   * the others.
   */
  void heard(GuidPrefix prefix, boolean automatic) {
    readers.forEach((writer, all) -> {
      if (!writer.prefix().equals(prefix)) return;
      for (StatefulReader reader : all) {
        WriterProxy proxy = reader.of(writer);
        if (proxy != null && proxy.isAutomatic() == automatic) proxy.heard();
      }
    });
  }
}
