package org.urbi.kernel.object;

/**
 * The state of simultaneous assignments to a slot (the property {@code blend}), which the
 * interpreter keeps with the slot.
 */
public interface SlotBlending {}
