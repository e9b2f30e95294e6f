package org.urbi.ros.two;

import static org.urbi.ros.two.GoalIds.part;

import java.util.List;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.urbi.ros.graph.ParameterDescription;
import org.urbi.ros.message.MessageType;
import org.urbi.ros.message.Templates;
import urbi.UDictionary;
import urbi.UList;
import urbi.UValue;

/** The services by which other nodes of ROS 2 get and set the parameters of this one. */
final class ParameterServices {
  private final TwoHost node;
  private final OwnParameters parameters;
  private final MessageType descriptor;

  private ParameterServices(TwoHost node, OwnParameters parameters) {
    this.node = node;
    this.parameters = parameters;
    descriptor = node.definitions().message("rcl_interfaces/ParameterDescriptor");
  }

  static void serve(TwoHost node, OwnParameters parameters) {
    ParameterServices all = new ParameterServices(node, parameters);
    all.serve("get_parameters", "GetParameters", all::get);
    all.serve("get_parameter_types", "GetParameterTypes", all::types);
    all.serve("set_parameters", "SetParameters", all::set);
    all.serve("set_parameters_atomically", "SetParametersAtomically", all::setAtomically);
    all.serve("describe_parameters", "DescribeParameters", all::describe);
    all.serve("list_parameters", "ListParameters", all::list);
  }

  private void serve(String name, String type, Function<UDictionary, UDictionary> answer) {
    node.serve(
        node.name() + "/" + name,
        node.definitions().service("rcl_interfaces/" + type),
        request -> CompletableFuture.completedFuture(answer.apply(request)));
  }

  private static List<String> texts(UDictionary request, String field) {
    return part(request, field).ulistValue().stream().map(UValue::stringValue).toList();
  }

  private static <T> UDictionary each(String field, List<T> asked, Function<T, UValue> answer) {
    UList answers = new UList();
    asked.forEach(one -> answers.add(answer.apply(one)));
    return new UDictionary().with(field, new UValue(answers));
  }

  private UDictionary get(UDictionary request) {
    return each("values", texts(request, "names"), name -> new UValue(parameters.message(name)));
  }

  private UDictionary types(UDictionary request) {
    return each("types", texts(request, "names"), name -> part(parameters.message(name), "type"));
  }

  private static List<UDictionary> wanted(UDictionary request) {
    return part(request, "parameters").ulistValue().stream().map(UValue::udictionaryValue).toList();
  }

  private static UDictionary result(String problem) {
    return new UDictionary().with("successful", problem.isEmpty() ? 1 : 0).with("reason", problem);
  }

  private UDictionary set(UDictionary request) {
    return each(
        "results",
        wanted(request),
        one -> new UValue(result(parameters.setByOthers(List.of(one)))));
  }

  private UDictionary setAtomically(UDictionary request) {
    return new UDictionary().with("result", result(parameters.setByOthers(wanted(request))));
  }

  private UDictionary describe(UDictionary request) {
    return each("descriptors", texts(request, "names"), name -> new UValue(descriptor(name)));
  }

  private UDictionary descriptor(String name) {
    UDictionary told = Templates.of(descriptor).with("name", name);
    OwnParameters.Parameter known = parameters.find(name);
    if (known == null) return told;
    ParameterDescription description = known.description();
    told.with("type", known.kind().ordinal())
        .with("description", description.text())
        .with("read_only", description.readOnly() ? 1 : 0);
    if (description.hasRange()) {
      boolean isWhole =
          known.kind() == ParameterKind.INTEGER || known.kind() == ParameterKind.INTEGER_ARRAY;
      UDictionary range =
          new UDictionary()
              .with("from_value", description.from())
              .with("to_value", description.to())
              .with("step", description.step());
      told.with(isWhole ? "integer_range" : "floating_point_range", UList.of(range));
    }
    return told;
  }

  private UDictionary list(UDictionary request) {
    List<String> prefixes = texts(request, "prefixes");
    double depth = part(request, "depth").doubleValue();
    UList names = new UList();
    TreeSet<String> parents = new TreeSet<>();
    for (String name : parameters.names()) {
      boolean isWanted =
          prefixes.isEmpty()
              ? isWithin(name, depth)
              : prefixes.stream()
                  .anyMatch(prefix ->
                      name.equals(prefix)
                          || name.startsWith(prefix + ".")
                              && isWithin(name.substring(prefix.length() + 1), depth));
      if (!isWanted) continue;
      names.add(new UValue(name));
      int dot = name.lastIndexOf('.');
      if (dot > 0) parents.add(name.substring(0, dot));
    }
    UList above = new UList();
    parents.forEach(each -> above.add(new UValue(each)));
    return new UDictionary()
        .with(
            "result",
            new UDictionary().with("names", new UValue(names)).with("prefixes", new UValue(above)));
  }

  /** Whether a name has no more parts than that; any number for 0. */
  private static boolean isWithin(String name, double depth) {
    return depth == 0 || name.chars().filter(each -> each == '.').count() < depth;
  }
}
