// Shows pictures in a window through Vulkan, and saves what the window shows. A
// layer such as vkBasalt can change the pictures between the program and the
// window.
//
// show_picture PICTURE FRAMES RESULT [PICTURE FRAMES RESULT]...
// shows each PICTURE for FRAMES frames, then saves the window as RESULT. All
// files are PPM (P6, 8 bits). The first picture sets the size of the window,
// and the others must have the same size.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>
#define VK_USE_PLATFORM_XCB_KHR
#include <vulkan/vulkan.h>
#include <xcb/xcb.h>

namespace {
constexpr auto no_timeout = std::numeric_limits<std::uint64_t>::max();
constexpr auto format = VK_FORMAT_B8G8R8A8_UNORM;  // stores 8-bit values unchanged
constexpr std::uint32_t texel_bytes = 4;

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> bgra;  // rows from the top
};

void require(bool is_good, const std::string& message) {
    if (!is_good)
        throw std::runtime_error(message);
}

void require(VkResult result, const std::string& call) {
    require(result == VK_SUCCESS || result == VK_SUBOPTIMAL_KHR,
            call + " failed with " + std::to_string(result) + ".");
}

Picture read_ppm(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string kind;
    unsigned int largest = 0;
    Picture picture;
    file >> kind >> picture.width >> picture.height >> largest;
    file.get();
    require(file && kind == "P6" && largest == 255, path + " is not a PPM file with 8 bits.");
    std::vector<char> rgb(std::size_t{3} * picture.width * picture.height);
    file.read(rgb.data(), static_cast<std::streamsize>(rgb.size()));
    require(file.good(), path + " is too short.");
    for (std::size_t i = 0; i < rgb.size(); i += 3)
        for (const std::uint8_t byte :
             {static_cast<std::uint8_t>(rgb[i + 2]), static_cast<std::uint8_t>(rgb[i + 1]),
              static_cast<std::uint8_t>(rgb[i]), std::uint8_t{255}})
            picture.bgra.push_back(byte);
    return picture;
}

void write_ppm(const std::string& path, const Picture& picture) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << picture.width << ' ' << picture.height << "\n255\n";
    for (std::size_t i = 0; i < picture.bgra.size(); i += texel_bytes)
        for (const std::size_t channel : {2, 1, 0})
            file.put(static_cast<char>(picture.bgra[i + channel]));
    require(file.good(), path + " cannot be written.");
}

/// A window of an X server without a window manager.
class Window {
public:
    Window(std::uint32_t width, std::uint32_t height)
        : m_connection(xcb_connect(nullptr, nullptr)), m_width(width), m_height(height) {
        require(xcb_connection_has_error(m_connection) == 0, "There is no X server.");
        const xcb_screen_t& screen = *xcb_setup_roots_iterator(xcb_get_setup(m_connection)).data;
        m_id = xcb_generate_id(m_connection);
        const std::uint32_t events = XCB_EVENT_MASK_EXPOSURE;
        xcb_create_window(m_connection, screen.root_depth, m_id, screen.root, 0, 0,
                          static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), 0,
                          XCB_WINDOW_CLASS_INPUT_OUTPUT, screen.root_visual, XCB_CW_EVENT_MASK,
                          &events);
        xcb_map_window(m_connection, m_id);
        xcb_flush(m_connection);
        wait_until_visible();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window() { xcb_disconnect(m_connection); }

    xcb_connection_t* connection() const { return m_connection; }
    xcb_window_t id() const { return m_id; }

    /// What the window shows. The driver presents over the same connection, so
    /// the server has finished all earlier presents before it answers.
    Picture picture() const {
        const auto cookie =
            xcb_get_image(m_connection, XCB_IMAGE_FORMAT_Z_PIXMAP, m_id, 0, 0,
                          static_cast<std::uint16_t>(m_width), static_cast<std::uint16_t>(m_height),
                          std::numeric_limits<std::uint32_t>::max());
        const std::unique_ptr<xcb_get_image_reply_t, decltype(&std::free)> reply(
            xcb_get_image_reply(m_connection, cookie, nullptr), &std::free);
        require(reply != nullptr, "The window cannot be read.");
        const std::span<const std::uint8_t> bytes(
            xcb_get_image_data(reply.get()),
            static_cast<std::size_t>(xcb_get_image_data_length(reply.get())));
        require(bytes.size() == std::size_t{m_width} * m_height * texel_bytes,
                "The X server does not have 24-bit colours.");
        return {m_width, m_height, {bytes.begin(), bytes.end()}};
    }

private:
    void wait_until_visible() {
        for (;;) {
            const std::unique_ptr<xcb_generic_event_t, decltype(&std::free)> event(
                xcb_wait_for_event(m_connection), &std::free);
            require(event != nullptr, "The X server has ended.");
            if ((event->response_type & 0x7f) == XCB_EXPOSE)
                return;
        }
    }

    xcb_connection_t* m_connection;
    xcb_window_t m_id = 0;
    std::uint32_t m_width;
    std::uint32_t m_height;
};

/// The Vulkan objects of the program. The end of the process frees them.
struct Device {
    VkInstance instance = nullptr;
    VkPhysicalDevice physical = nullptr;
    VkDevice logical = nullptr;
    VkQueue queue = nullptr;
    VkSurfaceKHR surface = nullptr;
    VkSwapchainKHR swapchain = nullptr;
    std::vector<VkImage> images;
    VkCommandBuffer commands = nullptr;
    VkSemaphore is_free = nullptr;
    VkSemaphore is_drawn = nullptr;
    VkFence is_done = nullptr;
    VkBuffer buffer = nullptr;
    std::uint8_t* bytes = nullptr;  // of the buffer
};

void open_instance(Device& device, const Window& window) {
    const char* const extensions[] = {VK_KHR_SURFACE_EXTENSION_NAME,
                                      VK_KHR_XCB_SURFACE_EXTENSION_NAME};
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_1;
    VkInstanceCreateInfo instance{};
    instance.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    instance.pApplicationInfo = &application;
    instance.enabledExtensionCount = 2;
    instance.ppEnabledExtensionNames = extensions;
    require(vkCreateInstance(&instance, nullptr, &device.instance), "vkCreateInstance");
    VkXcbSurfaceCreateInfoKHR surface{};
    surface.sType = VK_STRUCTURE_TYPE_XCB_SURFACE_CREATE_INFO_KHR;
    surface.connection = window.connection();
    surface.window = window.id();
    require(vkCreateXcbSurfaceKHR(device.instance, &surface, nullptr, &device.surface),
            "vkCreateXcbSurfaceKHR");
}

// Software drivers have one queue family, which does everything.
void open_device(Device& device) {
    std::uint32_t count = 1;
    require(vkEnumeratePhysicalDevices(device.instance, &count, &device.physical) >= VK_SUCCESS &&
                count == 1,
            "There is no Vulkan driver.");
    VkBool32 can_present = VK_FALSE;
    vkGetPhysicalDeviceSurfaceSupportKHR(device.physical, 0, device.surface, &can_present);
    require(can_present == VK_TRUE, "The Vulkan driver cannot draw into the window.");
    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
    require(vkCreateDevice(device.physical, &info, nullptr, &device.logical), "vkCreateDevice");
    vkGetDeviceQueue(device.logical, 0, 0, &device.queue);
}

void open_swapchain(Device& device, VkExtent2D size) {
    VkSurfaceCapabilitiesKHR capabilities{};
    require(
        vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physical, device.surface, &capabilities),
        "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    VkSwapchainCreateInfoKHR info{};
    info.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR;
    info.surface = device.surface;
    info.minImageCount = capabilities.minImageCount;
    info.imageFormat = format;
    info.imageColorSpace = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
    info.imageExtent = size;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    require(vkCreateSwapchainKHR(device.logical, &info, nullptr, &device.swapchain),
            "vkCreateSwapchainKHR");
    std::uint32_t count = 0;
    vkGetSwapchainImagesKHR(device.logical, device.swapchain, &count, nullptr);
    device.images.resize(count);
    require(vkGetSwapchainImagesKHR(device.logical, device.swapchain, &count, device.images.data()),
            "vkGetSwapchainImagesKHR");
}

// A buffer that both the program and the driver see.
void open_buffer(Device& device, VkDeviceSize size) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = size;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    require(vkCreateBuffer(device.logical, &info, nullptr, &device.buffer), "vkCreateBuffer");
    VkMemoryRequirements needed{};
    vkGetBufferMemoryRequirements(device.logical, device.buffer, &needed);
    VkPhysicalDeviceMemoryProperties memories{};
    vkGetPhysicalDeviceMemoryProperties(device.physical, &memories);
    constexpr VkMemoryPropertyFlags shared =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    std::uint32_t type = 0;
    while (type < memories.memoryTypeCount &&
           ((needed.memoryTypeBits >> type & 1U) == 0 ||
            (memories.memoryTypes[type].propertyFlags & shared) != shared))
        ++type;
    require(type < memories.memoryTypeCount, "The Vulkan driver has no shared memory.");
    VkMemoryAllocateInfo allocation{};
    allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocation.allocationSize = needed.size;
    allocation.memoryTypeIndex = type;
    VkDeviceMemory memory = nullptr;
    require(vkAllocateMemory(device.logical, &allocation, nullptr, &memory), "vkAllocateMemory");
    require(vkBindBufferMemory(device.logical, device.buffer, memory, 0), "vkBindBufferMemory");
    void* bytes = nullptr;
    require(vkMapMemory(device.logical, memory, 0, VK_WHOLE_SIZE, 0, &bytes), "vkMapMemory");
    device.bytes = static_cast<std::uint8_t*>(bytes);
}

void open_commands(Device& device) {
    VkCommandPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    VkCommandPool pool = nullptr;
    require(vkCreateCommandPool(device.logical, &pool_info, nullptr, &pool), "vkCreateCommandPool");
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = pool;
    info.commandBufferCount = 1;
    require(vkAllocateCommandBuffers(device.logical, &info, &device.commands),
            "vkAllocateCommandBuffers");
    VkSemaphoreCreateInfo semaphore{};
    semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
    for (VkSemaphore* target : {&device.is_free, &device.is_drawn})
        require(vkCreateSemaphore(device.logical, &semaphore, nullptr, target),
                "vkCreateSemaphore");
    VkFenceCreateInfo fence{};
    fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
    require(vkCreateFence(device.logical, &fence, nullptr, &device.is_done), "vkCreateFence");
}

void change_layout(const Device& device, VkImage image, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_MEMORY_READ_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(device.commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1,
                         &barrier);
}

// Records the copy of the buffer to an image of the swapchain.
void record_copy(const Device& device, VkImage image, VkExtent2D size) {
    VkCommandBufferBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
    require(vkBeginCommandBuffer(device.commands, &begin), "vkBeginCommandBuffer");
    change_layout(device, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {size.width, size.height, 1};
    vkCmdCopyBufferToImage(device.commands, device.buffer, image,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    change_layout(device, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                  VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
    require(vkEndCommandBuffer(device.commands), "vkEndCommandBuffer");
}

void show_frame(const Device& device, VkExtent2D size) {
    std::uint32_t index = 0;
    require(vkAcquireNextImageKHR(device.logical, device.swapchain, no_timeout, device.is_free,
                                  nullptr, &index),
            "vkAcquireNextImageKHR");
    record_copy(device, device.images[index], size);
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_TRANSFER_BIT;
    VkSubmitInfo submit{};
    submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
    submit.waitSemaphoreCount = 1;
    submit.pWaitSemaphores = &device.is_free;
    submit.pWaitDstStageMask = &stage;
    submit.commandBufferCount = 1;
    submit.pCommandBuffers = &device.commands;
    submit.signalSemaphoreCount = 1;
    submit.pSignalSemaphores = &device.is_drawn;
    require(vkQueueSubmit(device.queue, 1, &submit, device.is_done), "vkQueueSubmit");
    VkPresentInfoKHR present{};
    present.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR;
    present.waitSemaphoreCount = 1;
    present.pWaitSemaphores = &device.is_drawn;
    present.swapchainCount = 1;
    present.pSwapchains = &device.swapchain;
    present.pImageIndices = &index;
    require(vkQueuePresentKHR(device.queue, &present), "vkQueuePresentKHR");
    require(vkWaitForFences(device.logical, 1, &device.is_done, VK_TRUE, no_timeout),
            "vkWaitForFences");
    require(vkResetFences(device.logical, 1, &device.is_done), "vkResetFences");
}

void show_all(std::span<const std::string> arguments) {
    const Picture first = read_ppm(arguments[0]);
    const Window window(first.width, first.height);
    const VkExtent2D size{first.width, first.height};
    Device device;
    open_instance(device, window);
    open_device(device);
    open_swapchain(device, size);
    open_buffer(device, first.bgra.size());
    open_commands(device);
    for (; !arguments.empty(); arguments = arguments.subspan(3)) {
        const Picture picture = read_ppm(arguments[0]);
        require(picture.width == size.width && picture.height == size.height,
                arguments[0] + " has another size than " + "the first picture.");
        std::memcpy(device.bytes, picture.bgra.data(), picture.bgra.size());
        const int frames = std::stoi(arguments[1]);
        for (int frame = 0; frame < frames; ++frame)
            show_frame(device, size);
        require(vkDeviceWaitIdle(device.logical), "vkDeviceWaitIdle");
        write_ppm(arguments[2], window.picture());
    }
    vkDestroySwapchainKHR(device.logical, device.swapchain, nullptr);
}
}  // namespace

int main(int count, char** values) {
    const std::vector<std::string> arguments(values + 1, values + count);
    if (arguments.empty() || arguments.size() % 3 != 0) {
        std::cerr << "Usage: show_picture PICTURE FRAMES RESULT [PICTURE FRAMES "
                     "RESULT]...\n";
        return 2;
    }
    try {
        show_all(arguments);
    } catch (const std::exception& error) {
        std::cerr << "show_picture: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
