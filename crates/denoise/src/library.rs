//! Open Image Denoise's C interface (its header oidn.h, version 2), declared as far as it is needed, and the library loaded
//! while the program runs.
//!
//! This file alone of the crate has `unsafe`. The invariants:
//! - A [`Library`] holds functions of a library that stays loaded until the program ends, with the types of its header. That
//!   a file with all these names is Open Image Denoise is up to who put it there; its version is asked first, and any but 2
//!   is refused.
//! - A [`Device`] and a [`Filter`] are not null and are released once, the filter before its device. They stay on the thread
//!   that made them, where the library keeps its errors.
//! - A filter is given slices of the length that its size says, and is released before they go: [`Device::filter`] does
//!   both. It is the processor's device, which reads and writes all memory of the program.
#![allow(unsafe_code)]

use std::error::Error;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::fmt;
use std::path::Path;
use std::ptr::{null, null_mut};

type Handle = *mut c_void;

/// The processor, among the kinds of devices.
const CPU: c_int = 1;
/// No error.
const NONE: c_int = 0;
/// Three 32-bit floats for each pixel.
const FLOAT3: c_int = 3;

macro_rules! api {
    ($($name:ident = $symbol:literal: fn($($argument:ty),*) $(-> $result:ty)?;)*) => {
        /// The functions that are used.
        #[derive(Clone, Copy)]
        struct Api {
            $($name: unsafe extern "C" fn($($argument),*) $(-> $result)?,)*
        }

        impl Api {
            fn load(file: &Path) -> Result<Self, String> {
                // SAFETY: the library's initialisers are those of Open Image Denoise and of its task scheduler; the types are
                // those of its header, see the opening of this file.
                unsafe {
                    let library = open(file).map_err(|e| reason(&e))?;
                    let api = Self {
                        $($name: *library.get($symbol).map_err(|_| missing($symbol))?,)*
                    };
                    // Its threads may outlive its devices: it stays until the program ends.
                    std::mem::forget(library);
                    Ok(api)
                }
            }
        }
    };
}

api! {
    new_device = "oidnNewDevice": fn(c_int) -> Handle;
    release_device = "oidnReleaseDevice": fn(Handle);
    commit_device = "oidnCommitDevice": fn(Handle);
    get_device_int = "oidnGetDeviceInt": fn(Handle, *const c_char) -> c_int;
    set_device_int = "oidnSetDeviceInt": fn(Handle, *const c_char, c_int);
    device_error = "oidnGetDeviceError": fn(Handle, *mut *const c_char) -> c_int;
    new_filter = "oidnNewFilter": fn(Handle, *const c_char) -> Handle;
    release_filter = "oidnReleaseFilter": fn(Handle);
    commit_filter = "oidnCommitFilter": fn(Handle);
    execute_filter = "oidnExecuteFilter": fn(Handle);
    set_filter_bool = "oidnSetFilterBool": fn(Handle, *const c_char, bool);
    set_filter_int = "oidnSetFilterInt": fn(Handle, *const c_char, c_int);
    set_filter_image = "oidnSetSharedFilterImage":
        fn(Handle, *const c_char, *mut c_void, c_int, usize, usize, usize, usize, usize);
}

/// Loads a library, by a bare name from where the system looks.
///
/// # Safety
/// As [`libloading::Library::new`].
#[cfg(not(windows))]
unsafe fn open(file: &Path) -> Result<libloading::Library, libloading::Error> {
    // SAFETY: up to the caller.
    unsafe { libloading::Library::new(file) }
}

/// Loads a library, by a bare name from where the system looks; from a folder together with what it needs from there.
///
/// # Safety
/// As [`libloading::Library::new`].
#[cfg(windows)]
unsafe fn open(file: &Path) -> Result<libloading::Library, libloading::Error> {
    use libloading::os::windows::{LOAD_WITH_ALTERED_SEARCH_PATH, Library};
    let flags = if file.is_absolute() { LOAD_WITH_ALTERED_SEARCH_PATH } else { 0 };
    // SAFETY: up to the caller.
    unsafe { Library::load_with_flags(file, flags) }.map(Into::into)
}

/// The system's reason why a file is no library.
fn reason(error: &libloading::Error) -> String {
    error.source().map_or_else(|| error.to_string(), ToString::to_string)
}

fn missing(symbol: &str) -> String {
    format!("this is not Open Image Denoise 2, the function {symbol} is missing")
}

/// The library, loaded and found to be of version 2.
#[derive(Clone, Copy)]
pub struct Library {
    api: Api,
    /// As 20501 for 2.5.1.
    version: c_int,
}

impl Library {
    /// Loads it from a file, or from where the system looks for libraries of that name.
    ///
    /// # Errors
    /// Why it cannot be used.
    pub fn load(file: &Path) -> Result<Self, String> {
        let mut library = Self { api: Api::load(file)?, version: 0 };
        let device = Device::new(&library)?;
        // SAFETY: the device lives; the name ends with a zero.
        let version = unsafe { (library.api.get_device_int)(device.handle, c"version".as_ptr()) };
        drop(device);
        library.version = version;
        if version / 10_000 == 2 {
            Ok(library)
        } else {
            Err(format!("this is Open Image Denoise {}, and version 2 is needed", library.version()))
        }
    }

    /// As "2.5.1".
    pub fn version(&self) -> String {
        let v = self.version;
        format!("{}.{}.{}", v / 10_000, v / 100 % 100, v % 100)
    }

    /// The processor, ready for work on so many threads; 0: as many as the library finds best.
    ///
    /// # Errors
    /// The library's text.
    pub fn device(&self, threads: usize) -> Result<Device<'_>, String> {
        let device = Device::new(self)?;
        if threads > 0 {
            let threads = c_int::try_from(threads).unwrap_or(c_int::MAX);
            // SAFETY: the device lives; the name ends with a zero.
            unsafe { (self.api.set_device_int)(device.handle, c"numThreads".as_ptr(), threads) };
        }
        // SAFETY: the device lives.
        unsafe { (self.api.commit_device)(device.handle) };
        device.check()?;
        Ok(device)
    }
}

impl fmt::Debug for Library {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Library").field("version", &self.version).finish_non_exhaustive()
    }
}

/// What a filter is given.
#[derive(Debug)]
pub struct Job<'a> {
    /// Width and height in pixels.
    pub size: [usize; 2],
    /// The library's names for the pictures that go in, and their pixels, three floats each.
    pub inputs: &'a [(&'static CStr, &'a [f32])],
    /// The library's names of what is true.
    pub claims: &'a [&'static CStr],
    /// The library's number for the quality.
    pub quality: c_int,
}

/// The processor, as the library sees it.
#[derive(Debug)]
pub struct Device<'a> {
    library: &'a Library,
    handle: Handle,
}

impl<'a> Device<'a> {
    fn new(library: &'a Library) -> Result<Self, String> {
        // SAFETY: any number may be passed.
        let handle = unsafe { (library.api.new_device)(CPU) };
        if handle.is_null() {
            Err(error_of(&library.api, null_mut()).unwrap_or_else(|| "it cannot use this processor".into()))
        } else {
            Ok(Self { library, handle })
        }
    }

    /// What went wrong since it was asked last.
    fn check(&self) -> Result<(), String> {
        error_of(&self.library.api, self.handle).map_or(Ok(()), Err)
    }

    /// Runs the filter for ray-traced pictures, and gives back what comes out, three floats for each pixel.
    ///
    /// # Errors
    /// The library's text.
    ///
    /// # Panics
    /// When an input has not as many floats as the size says.
    pub fn filter(&self, job: &Job<'_>) -> Result<Vec<f32>, String> {
        let floats = 3 * job.size[0] * job.size[1];
        assert!(job.inputs.iter().all(|(_, pixels)| pixels.len() == floats), "all pictures are whole");
        let mut output = vec![0.0_f32; floats];
        let filter = Filter::new(self)?;
        for (name, pixels) in job.inputs {
            // The library only reads from inputs, though it takes all pictures as if they were to be written.
            filter.set_image(name, pixels.as_ptr().cast_mut(), job.size);
        }
        filter.set_image(c"output", output.as_mut_ptr(), job.size);
        let api = &self.library.api;
        // SAFETY: the filter lives, the names end with zeros, and the pictures are there until it is released.
        unsafe {
            for claim in job.claims {
                (api.set_filter_bool)(filter.handle, claim.as_ptr(), true);
            }
            (api.set_filter_int)(filter.handle, c"quality".as_ptr(), job.quality);
            (api.commit_filter)(filter.handle);
        }
        self.check()?;
        // SAFETY: as above; it returns when the work is done.
        unsafe { (api.execute_filter)(filter.handle) };
        self.check()?;
        drop(filter);
        Ok(output)
    }
}

impl Drop for Device<'_> {
    fn drop(&mut self) {
        // SAFETY: it lives and is released this once; its filters are gone, for they borrow it.
        unsafe { (self.library.api.release_device)(self.handle) };
    }
}

/// The last error of a device, or of making one where the device is null.
fn error_of(api: &Api, device: Handle) -> Option<String> {
    let mut text: *const c_char = null();
    // SAFETY: the device lives or is null, which the library allows; the text is valid until the next call and is copied.
    unsafe {
        let code = (api.device_error)(device, &mut text);
        if code == NONE {
            return None;
        }
        if text.is_null() {
            return Some(format!("error {code}"));
        }
        Some(CStr::from_ptr(text).to_string_lossy().into_owned())
    }
}

/// A filter while it is set up and runs.
struct Filter<'a> {
    api: &'a Api,
    handle: Handle,
}

impl<'a> Filter<'a> {
    fn new(device: &'a Device<'_>) -> Result<Self, String> {
        let api = &device.library.api;
        // SAFETY: the device lives; the name ends with a zero.
        let handle = unsafe { (api.new_filter)(device.handle, c"RT".as_ptr()) };
        device.check()?;
        if handle.is_null() { Err("it made no filter".into()) } else { Ok(Self { api, handle }) }
    }

    /// Shares a picture of three floats for each pixel with the filter, row after row without gaps.
    fn set_image(&self, name: &CStr, pixels: *mut f32, [width, height]: [usize; 2]) {
        // SAFETY: the filter lives; nothing is read or written before it runs.
        unsafe {
            (self.api.set_filter_image)(
                self.handle,
                name.as_ptr(),
                pixels.cast(),
                FLOAT3,
                width,
                height,
                0,
                0,
                0,
            );
        }
    }
}

impl Drop for Filter<'_> {
    fn drop(&mut self) {
        // SAFETY: it lives and is released this once.
        unsafe { (self.api.release_filter)(self.handle) };
    }
}
