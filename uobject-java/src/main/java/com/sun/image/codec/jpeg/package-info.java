/**
 * Two classes that Java had until version 8, and that programs of Urbi 2.7 read JPEG images with.
 */
@NullMarked
package com.sun.image.codec.jpeg;

import org.jspecify.annotations.NullMarked;
