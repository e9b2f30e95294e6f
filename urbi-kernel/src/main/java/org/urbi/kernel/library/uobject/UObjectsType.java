package org.urbi.kernel.library.uobject;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.event.CallTimes;
import org.urbi.kernel.library.lobby.LobbyType;
import org.urbi.kernel.log.KernelLog;
import org.urbi.kernel.node.DictionaryKey;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Truth;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.object.Values;
import org.urbi.kernel.uobject.ObjectAccess;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiConnection;
import org.urbi.kernel.variable.UrbiUVar;

/** Where the UObjects are (manual, "uobjects"). */
@UrbiType(
    value = "uobjects",
    doc = "The namespace of the UObjects, each under its unique name.",
    needs = Permission.NOTHING)
final class UObjectsType {
  private final PluggedContext uobjects;
  private final KernelLog log;

  UObjectsType(PluggedContext uobjects, KernelLog log) {
    this.uobjects = uobjects;
    this.log = log;
  }

  @Builtin(doc = "The UObject of that name; nil if there is none.")
  UrbiObject findUObject(Frame frame, UrbiObject self, String name) {
    UrbiObject found = new ObjectAccess(uobjects).find(Utf8Text.toJava(name));
    return found == null ? frame.interpreter().values().nil : found;
  }

  @Builtin(doc = "Enables or disables the measuring of bound functions.", needs = Permission.OWNER)
  void enableStats(Frame frame, UrbiObject self, UrbiObject on) {
    uobjects.statistics().enable(Truth.of(frame, on));
  }

  @Builtin(doc = "Forgets what was measured of bound functions.", needs = Permission.OWNER)
  void clearStats(Frame frame, UrbiObject self) {
    uobjects.statistics().clear();
  }

  @Builtin(
      doc =
          "By their names, the average, least and most time in seconds that bound functions took,"
              + " and the number of calls.")
  UrbiObject getStats(Frame frame, UrbiObject self) {
    Values values = frame.interpreter().values();
    Map<UrbiDictionary.Key, UrbiObject> entries = new LinkedHashMap<>();
    uobjects
        .statistics()
        .all()
        .forEach((name, times) ->
            entries.put(
                DictionaryKey.of(frame, values.string(Utf8Text.toUrbi(name))),
                values.list(numbers(values, times))));
    return values.dictionary(entries);
  }

  private static List<UrbiObject> numbers(Values values, CallTimes times) {
    return List.of(
        values.number(times.mean()),
        values.number(times.least()),
        values.number(times.most()),
        values.number(times.count()));
  }

  @Builtin(doc = "Shows the statistics of all the links between variables.")
  void connectionStats(Frame frame, UrbiObject self) {
    List<UrbiConnection> all = uobjects.connections().all();
    List<String> lines = new ArrayList<>();
    for (UrbiConnection connection : all) {
      UrbiUVar source = connection.source();
      UrbiUVar target = connection.target();
      if (source != null && target != null) {
        CallTimes times = connection.gate().times();
        lines.add(
            String.format(
                Locale.ROOT,
                "%s >> %s: %d calls, %.1f Hz, call time mean %.6f min %.6f max %.6f",
                source.name(),
                target.name(),
                times.count(),
                connection.gate().fireRate(),
                times.mean(),
                times.least(),
                times.most()));
      }
    }
    for (String line : lines) {
      LobbyType.output(frame).send("", "*** " + line);
    }
  }

  @Builtin(
      doc = "Forgets the statistics of all the links between variables.",
      needs = Permission.OWNER)
  void resetConnectionStats(Frame frame, UrbiObject self) {
    uobjects.connections().all().forEach(link -> link.gate().times().reset());
  }

  @Builtin(
      doc = "Enables or disables messages of the log about each call of a bound function.",
      needs = Permission.OWNER)
  void setTrace(Frame frame, UrbiObject self, UrbiObject on) {
    uobjects.statistics().trace(Truth.of(frame, on) ? log::write : null);
  }

  @Builtin(doc = "The folders where modules are looked for.")
  List<UrbiObject> searchPath(Frame frame, UrbiObject self) {
    return new UObjectType(uobjects).searchPath(frame, self);
  }
}
