package org.urbi.kernel.tier;

import java.lang.classfile.ClassBuilder;
import java.lang.classfile.ClassFile;
import java.lang.classfile.constantpool.ConstantPoolBuilder;
import java.lang.classfile.constantpool.FieldRefEntry;
import java.lang.classfile.constantpool.InterfaceMethodRefEntry;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.lang.invoke.MethodHandles;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/** The objects to which emitted code refers: static finals of its class, which a JIT trusts. */
final class Constants {
  private record Constant(FieldRefEntry field, Object value) {}

  private static final ClassDesc HANDLES = MethodHandles.class.describeConstable().orElseThrow();

  private static final MethodTypeDesc GET =
      MethodTypeDesc.of(ConstantDescs.CD_Object, ConstantDescs.CD_int);

  private final Map<Object, Map<ClassDesc, Constant>> known = new IdentityHashMap<>();
  private final List<Constant> all = new ArrayList<>();

  /** The field that holds an object as a type. */
  FieldRefEntry field(ConstantPoolBuilder pool, ClassDesc owner, Object value, ClassDesc type) {
    return known
        .computeIfAbsent(value, each -> new HashMap<>(2))
        .computeIfAbsent(
            type,
            each -> {
              var constant = new Constant(pool.fieldRefEntry(owner, "c" + all.size(), type), value);
              all.add(constant);
              return constant;
            })
        .field;
  }

  /** The objects, for the definition of the class. */
  List<Object> values() {
    return all.stream().map(Constant::value).toList();
  }

  /** Declares the fields, and the code that fills them from the data of the class. */
  void declare(ClassBuilder to) {
    for (Constant constant : all) {
      to.withField(
          constant.field.name(),
          constant.field.type(),
          ClassFile.ACC_PRIVATE | ClassFile.ACC_STATIC | ClassFile.ACC_FINAL);
    }
    to.withMethodBody(
        ConstantDescs.CLASS_INIT_NAME,
        ConstantDescs.MTD_void,
        ClassFile.ACC_STATIC,
        code -> {
          code.invokestatic(
              HANDLES, "lookup", MethodTypeDesc.of(ConstantDescs.CD_MethodHandles_Lookup));
          code.loadConstant(ConstantDescs.DEFAULT_NAME);
          code.loadConstant(ConstantDescs.CD_List);
          code.invokestatic(
              HANDLES,
              "classData",
              MethodTypeDesc.of(
                  ConstantDescs.CD_Object,
                  ConstantDescs.CD_MethodHandles_Lookup,
                  ConstantDescs.CD_String,
                  ConstantDescs.CD_Class));
          code.checkcast(ConstantDescs.CD_List).astore(0);
          InterfaceMethodRefEntry get =
              code.constantPool().interfaceMethodRefEntry(ConstantDescs.CD_List, "get", GET);
          for (int i = 0; i < all.size(); i++) {
            Constant constant = all.get(i);
            code.aload(0)
                .loadConstant(i)
                .invokeinterface(get)
                .checkcast(constant.field.typeSymbol())
                .putstatic(constant.field);
          }
          code.return_();
        });
  }
}
